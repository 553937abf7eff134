// A page in Debian's Chromium: opened from disk, watched for requests and errors.
import assert from 'node:assert/strict';
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';

export const ROOT = join(dirname(fileURLToPath(import.meta.url)), '../..');
const { chromium } = createRequire(join(ROOT, 'web/package.json'))('playwright-core');

const CHROMIUM = ['/usr/bin/chromium', '/usr/bin/chromium-browser'].find((path) => existsSync(path));
const ARGUMENTS = ['--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'];

/** As strict as that of the program's page (io/report/report.c). */
const POLICY =
  "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data: blob:; worker-src blob:; base-uri 'none'; form-action 'none'";

const ESCAPES = { '<': '\\u003c', '>': '\\u003e', '&': '\\u0026', '\u2028': '\\u2028', '\u2029': '\\u2029' };

/** One HTML file of the data and the committed bundle. */
export function html(data) {
  const text = JSON.stringify(data).replace(/[<>&\u2028\u2029]/g, (c) => ESCAPES[c]);
  const part = (name) => readFileSync(join(ROOT, 'web/dist', name), 'utf8');
  return `<!doctype html><html lang="en"><head><meta charset="utf-8"><meta http-equiv="Content-Security-Policy" content="${POLICY}">
<meta name="viewport" content="width=device-width, initial-scale=1"><title>hawser</title><style>${part('report.css')}</style></head>
<body><main id="hawser"></main><script type="application/json" id="hawser-data">${text}</script><script>${part('report.js')}</script></body></html>`;
}

/** Limit of one wait, ms: it ends what hangs and does not measure how fast a machine is. */
export const HANGS = 10 * 60 * 1000;

let browser;
const folder = mkdtempSync(join(tmpdir(), 'hawser-web-'));

export async function stop() {
  await browser?.close();
  rmSync(folder, { recursive: true, force: true });
}

/** Opens a file from disk and waits until it is there (`ready`). What the page asks of a network or says in the console is in `heard`, which has
 * to stay empty. */
export async function openFile(path, options = {}, ready = settled) {
  browser ??= await chromium.launch({ executablePath: CHROMIUM, args: ARGUMENTS, timeout: HANGS });
  const context = await browser.newContext({
    viewport: { width: 1280, height: 900 },
    acceptDownloads: true,
    ...options,
  });
  context.setDefaultTimeout(HANGS);
  const page = await context.newPage();
  const heard = [];
  page.on('request', (request) => {
    const url = request.url();
    if (url !== pathToFileURL(path).href && !/^(data|blob|about):/.test(url)) heard.push(`request of ${url}`);
  });
  page.on('console', (message) => ['error', 'warning'].includes(message.type()) && heard.push(message.text()));
  page.on('pageerror', (error) => heard.push(error.stack ?? error.message));
  await page.goto(pathToFileURL(path).href);
  await ready(page);
  return { page, heard, close: () => context.close() };
}

/** Until every figure is drawn, as after a change of units. */
export async function settled(page) {
  await page.waitForFunction(() => {
    const plots = [...document.querySelectorAll('.plot')];
    const made = document.querySelector('#hawser section') && plots.every((plot) => plot.querySelector('canvas'));
    return made || document.querySelector('.failed');
  });
}

export async function open(data, options) {
  const path = join(folder, 'page.html');
  writeFileSync(path, html(data));
  return openFile(path, options);
}

/** The CSV of a figure or a section, by its own button: rows of cells. */
export async function savedCsv(page, selector) {
  const [download] = await Promise.all([page.waitForEvent('download'), page.click(`${selector} >> text="Save CSV"`)]);
  return parseCsv(readFileSync(await download.path(), 'utf8'));
}

export function parseCsv(text) {
  const rows = [[]];
  for (const [, quoted, plain, end] of text.matchAll(/(?:"((?:[^"]|"")*)"|([^,\r\n]*))(,|\r\n|$)/g)) {
    if (quoted === undefined && plain === '' && end === '') continue;
    rows.at(-1).push(quoted === undefined ? plain : quoted.replaceAll('""', '"'));
    if (end === '\r\n') rows.push([]);
  }
  return rows.filter((row) => row.length > 0);
}

/** Column of a CSV whose heading begins with the label, as numbers; empty cells are null. */
export function column(rows, label) {
  const index = rows[0].findIndex((heading) => heading.startsWith(label));
  assert.notEqual(index, -1, `no column "${label}" among ${rows[0].join(' | ')}`);
  return rows.slice(1).map((row) => (row[index] === '' ? null : Number(row[index])));
}

/** Asserts that the numbers agree to 1e-9 of their size. */
export function assertClose(found, expected, what) {
  assert.equal(found.length, expected.length, `${what}: number of rows`);
  expected.forEach((value, i) => {
    if (value === null || value === undefined) assert.equal(found[i], null, `${what}[${i}]`);
    else
      assert.ok(
        Math.abs(found[i] - value) <= 1e-9 * Math.max(1e-6, Math.abs(value)),
        `${what}[${i}]: ${found[i]} is not ${value}`,
      );
  });
}
