// Pages with the view alone, and the browser that opens them.
import { createRequire } from 'node:module';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';

const HERE = fileURLToPath(new URL('.', import.meta.url));
const WEB = join(HERE, '../../../web');
const library = createRequire(join(WEB, 'package.json'));
const { build } = library('esbuild');
const { chromium } = library('playwright-core');
const POLICY = "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data: blob:";
const FLAGS = ['--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--no-sandbox'];

/** Bundles the entry once; makes pages of data; opens them. close() takes everything away. */
export async function pages(flags = FLAGS) {
  const folder = mkdtempSync(join(tmpdir(), 'hawser-view-'));
  await build({
    entryPoints: [join(HERE, 'entry.ts')],
    outdir: folder,
    bundle: true,
    minify: true,
    format: 'iife',
    target: 'es2022',
    nodePaths: [join(WEB, 'node_modules')],
    logLevel: 'warning',
  });
  const script = readFileSync(join(folder, 'entry.js'), 'utf8').replaceAll('</script', '<\\/script');
  const style = readFileSync(join(folder, 'entry.css'), 'utf8');
  const browser = await chromium.launch({
    executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
    args: flags,
  });
  const write = (name, data) => {
    const json = JSON.stringify(data).replace(
      /[<>&\u2028\u2029]/g,
      (c) => `\\u${c.charCodeAt(0).toString(16).padStart(4, '0')}`,
    );
    const file = join(folder, `${name}.html`);
    writeFileSync(
      file,
      `<!doctype html><html lang="en"><head><meta charset="utf-8"><meta http-equiv="Content-Security-Policy" content="${POLICY}"><title>view</title>` +
        `<style>${style}</style></head><body><main id="hawser"></main><script type="application/json" id="hawser-data">${json}</script>` +
        `<script>${script}</script></body></html>`,
    );
    return pathToFileURL(file).href;
  };
  /** Opens an address; the page's errors and requests gather in `page.complaints`. */
  const open = async (address, { width = 1200, height = 900, ...options } = {}) => {
    const page = await browser.newPage({
      viewport: { width, height },
      ...options,
    });
    page.complaints = [];
    page.on('pageerror', (error) => page.complaints.push(String(error)));
    page.on('console', (message) => message.type() === 'error' && page.complaints.push(message.text()));
    page.on('request', (request) => /^(file|data|blob):/.test(request.url()) || page.complaints.push(request.url()));
    await page.goto(address);
    await page.evaluate(() => window.hawser.view.ready);
    await settled(page);
    return page;
  };
  const close = async () => {
    await browser.close();
    rmSync(folder, { recursive: true, force: true });
  };
  return { write, open, close, browser };
}

/** Waits until two pictures more have been drawn. */
export const settled = (page) =>
  page.evaluate(
    () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(done, 30)))),
  );
