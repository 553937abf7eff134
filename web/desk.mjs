// Makes dist/desk.html of src/desk and the engine that scripts/wasm.sh has built: one file, which needs no other and no network.
// Usage: node desk.mjs ENGINE_DIR [FILE]     (default: dist/desk.html)
import { build } from 'esbuild';
import { createHash } from 'node:crypto';
import { readFileSync, writeFileSync } from 'node:fs';
import { deflateRawSync } from 'node:zlib';
import { licence } from './licence.mjs';

const folder = process.argv[2];
const libraries = new Set();

async function bundled(entry) {
  const made = await build({
    entryPoints: [entry],
    write: false,
    metafile: true,
    bundle: true,
    minify: true,
    format: 'iife',
    target: 'es2022',
    charset: 'ascii',
    legalComments: 'none',
    loader: { '.yaml': 'text' },
    logLevel: 'warning',
  });
  for (const input of Object.keys(made.metafile.inputs)) {
    const found = /node_modules\/((?:@[^/]+\/)?[^/]+)\//.exec(input);
    if (found) libraries.add(found[1]);
  }
  return made.outputFiles[0].text;
}

/** Nothing in an element ends it. */
const safe = (script) => script.replaceAll('</script', '<\\/script').replaceAll('<!--', '<\\!--');

const main = await bundled('src/desk/main.ts');
const script = safe(`${[...libraries].sort().map(licence).join('\n')}\n${main}`);
const sumOf = (text) => createHash('sha256').update(text).digest('base64');
// The report's program, which the desk shows runs with and the engine puts into their reports: what the policies allow.
const report = readFileSync('dist/report.js', 'utf8');
if (/<\/script|<!--/.test(report)) throw new Error('dist/report.js would end its element');
const parts = {
  POLICY: `default-src 'none'; script-src 'sha256-${sumOf(script)}' 'sha256-${sumOf(report)}' blob: 'wasm-unsafe-eval'; worker-src blob:; style-src 'unsafe-inline'; img-src data: blob:; base-uri 'none'; form-action 'none'`,
  STYLE: readFileSync('src/desk/desk.css', 'utf8'),
  ENGINE: deflateRawSync(readFileSync(`${folder}/hawser.wasm`), { level: 9 }).toString('base64'),
  CONVERTER: deflateRawSync(readFileSync('dist/convert.cjs'), { level: 9 }).toString('base64'),
  GLUE: safe(readFileSync(`${folder}/hawser.js`, 'utf8')),
  LICENCES: safe(readFileSync(`${folder}/licences.txt`, 'utf8')),
  REPORTSCRIPT: report,
  REPORTSTYLE: safe(readFileSync('dist/report.css', 'utf8')),
  REPORTSUM: sumOf(report),
  WORKER: safe(await bundled('src/desk/worker.ts')),
  SCRIPT: script,
};
const page = readFileSync('src/desk/desk.html.in', 'utf8').replace(
  /(?<=content="|>)(POLICY|STYLE|ENGINE|CONVERTER|GLUE|REPORTSCRIPT|REPORTSTYLE|REPORTSUM|LICENCES|WORKER|SCRIPT)(?=["<])/g,
  (_, part) => parts[part],
);
writeFileSync(process.argv[3] ?? 'dist/desk.html', page);
