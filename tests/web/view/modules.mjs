// The view's pure modules, for tests in Node.
import { createRequire } from 'node:module';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';

const WEB = fileURLToPath(new URL('../../../web/', import.meta.url));
const { build } = createRequire(join(WEB, 'package.json'))('esbuild');

/** Everything that these modules of web/src/view export. */
export async function modules(...names) {
  const folder = mkdtempSync(join(tmpdir(), 'hawser-view-'));
  const outfile = join(folder, 'all.mjs');
  const contents = names.map((name) => `export * from './${name}';`).join('\n');
  await build({
    stdin: { contents, resolveDir: join(WEB, 'src/view'), loader: 'ts' },
    bundle: true,
    format: 'esm',
    platform: 'neutral',
    outfile,
    logLevel: 'warning',
  });
  writeFileSync(join(folder, 'package.json'), '{"type":"module"}');
  try {
    return await import(pathToFileURL(outfile).href);
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
}
