// Bundles src/main.ts into dist/report.js and dist/report.css, with the licences of the libraries that are in them.
// Usage: node build.mjs [DIR]     (default: dist)
import { build } from 'esbuild';
import { readFileSync } from 'node:fs';

const libraries = ['three', 'uplot'];

/** A comment that keeps a library's licence; minifiers keep what begins with an exclamation mark. */
function licence(name) {
  const { version } = JSON.parse(readFileSync(`node_modules/${name}/package.json`, 'utf8'));
  const text = readFileSync(`node_modules/${name}/LICENSE`, 'utf8').trim();
  return `/*! ${name} ${version}\n\n${text}\n*/`;
}

const licences = libraries.map(licence).join('\n');

await build({
  entryPoints: { report: 'src/main.ts' },
  outdir: process.argv[2] ?? 'dist',
  bundle: true,
  minify: true,
  format: 'iife',
  target: 'es2022',
  charset: 'ascii',
  legalComments: 'none',
  banner: { js: licences, css: licence('uplot') },
  logLevel: 'warning',
});
