// Bundles src/convert/main.ts into dist/convert.cjs, the converter of models: node's child of `hawser convert`, and a worker of the desk.
// Usage: node convert.mjs [DIR]     (default: dist)
import { build } from 'esbuild';
import { readFileSync } from 'node:fs';
import { deflateRawSync } from 'node:zlib';
import { licence } from './licence.mjs';

const IFC = 'node_modules/web-ifc';

/** The section of web-ifc's bundle that loads its WebAssembly: the rest of it, 5 MB, are classes of the schemas, which nothing here uses. */
function ifcModule() {
  const text = readFileSync(`${IFC}/web-ifc-api-node.js`, 'utf8');
  const section =
    /\/\/ dist\/web-ifc-node\.js\nvar (require_web_ifc_node) = __commonJS\(\{\n([^]*?)\n\}\);\n\n\/\/ dist\/web-ifc-api\.ts\n/.exec(
      text,
    );
  if (!section) throw new Error('web-ifc-api-node.js: its WebAssembly module is not where it was');
  const [, , body] = section;
  return `const made = { exports: {} }; ({ ${body} })["dist/web-ifc-node.js"](made.exports, made); export default made.exports;`;
}

/** The WebAssembly itself, deflated, as base64. */
function ifcWasm() {
  const packed = deflateRawSync(readFileSync(`${IFC}/web-ifc-node.wasm`), { level: 9 }).toString('base64');
  return `const packed = ${JSON.stringify(packed)};
export default async function () {
  const bytes = Uint8Array.from(atob(packed), (c) => c.charCodeAt(0));
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate-raw'))).arrayBuffer();
}`;
}

const parts = { 'web-ifc-module': ifcModule, 'web-ifc-wasm': ifcWasm };

const webIfc = {
  name: 'web-ifc',
  setup({ onResolve, onLoad }) {
    onResolve({ filter: /^web-ifc-(module|wasm)$/ }, ({ path }) => ({ path, namespace: 'web-ifc' }));
    onLoad({ filter: /.*/, namespace: 'web-ifc' }, ({ path }) => ({ contents: parts[path](), loader: 'js' }));
  },
};

await build({
  entryPoints: { convert: 'src/convert/main.ts' },
  outdir: process.argv[2] ?? 'dist',
  outExtension: { '.js': '.cjs' },
  plugins: [webIfc],
  external: ['node:fs', 'fs', 'crypto'],
  bundle: true,
  minify: true,
  format: 'iife',
  target: 'es2022',
  charset: 'ascii',
  legalComments: 'none',
  banner: { js: ['three', 'web-ifc', '@xmldom/xmldom'].map(licence).join('\n') },
  logLevel: 'warning',
});
