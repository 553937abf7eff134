// Bundles src/main.ts into dist/report.js and dist/report.css, with the licences of the libraries that are in them.
// Usage: node build.mjs [DIR]     (default: dist)
import { build } from 'esbuild';
import { licence } from './licence.mjs';

const libraries = ['three', 'uplot'];

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
