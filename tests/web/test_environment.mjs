// The environment in the report's view, and models that are opened on the desk.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import test, { after } from 'node:test';
import { openFile, ROOT, stop } from './browser.mjs';
import { desk, textOf } from './desk.mjs';

const hawser = process.argv[2];
const folder = mkdtempSync(join(tmpdir(), 'hawser-environment-'));
after(async () => {
  await stop();
  rmSync(folder, { recursive: true, force: true });
});

/** Share of the picture's pixels that differ by more than a little. */
const differing = (page, before, after) =>
  page.evaluate(
    async ([a, b]) => {
      const pixels = async (base64) => {
        const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
        const picture = await createImageBitmap(new Blob([bytes], { type: 'image/png' }));
        const context = new OffscreenCanvas(picture.width, picture.height).getContext('2d');
        context.drawImage(picture, 0, 0);
        return context.getImageData(0, 0, picture.width, picture.height).data;
      };
      const [p, q] = [await pixels(a), await pixels(b)];
      let count = 0;
      for (let i = 0; i < p.length; i += 4) count += Math.abs(p[i] - q[i]) + Math.abs(p[i + 1] - q[i + 1]) > 12;
      return (4 * count) / p.length;
    },
    [before.toString('base64'), after.toString('base64')],
  );

test('the report shows the example tunnel, fades it and switches its layers', async () => {
  const report = join(folder, 'tunnel.html');
  const results = join(folder, 'tunnel');
  execFileSync(hawser, [
    'run',
    join(ROOT, 'cases/environment/tunnel.yaml'),
    '-q',
    '-o',
    results,
    '--set',
    'solver.passes=1',
  ]);
  execFileSync(hawser, ['report', results, '-q', '-o', report]);
  assert.ok(readFileSync(report).length < 10e6);
  const { page, heard, close } = await openFile(report);
  await page.locator('#view').scrollIntoViewIfNeeded();
  await page.locator('.view-layers summary').click();
  await page.waitForTimeout(2000);
  const canvas = page.locator('.view-stage canvas');
  const full = await canvas.screenshot();
  assert.match(
    await page.locator('.view-layers').innerText(),
    /all 2\d{3} triangles, corners rounded to 1(\.0+)?\s*mm/,
  );
  await page.getByLabel('walls', { exact: true }).uncheck();
  await page.waitForTimeout(500);
  const withoutWalls = await canvas.screenshot();
  assert.ok((await differing(page, full, withoutWalls)) > 0.01, 'the walls go');
  await page.getByLabel('walls', { exact: true }).check();
  await page.getByLabel('cut away toward the camera').uncheck();
  await page.waitForTimeout(500);
  assert.ok((await differing(page, full, await canvas.screenshot())) > 0.003, 'the near wall comes');
  await page.getByLabel('How solid the environment is drawn').fill('0');
  await page.waitForTimeout(500);
  assert.ok((await differing(page, full, await canvas.screenshot())) > 0.01, 'all of it goes');
  assert.deepEqual(
    heard.filter((text) => !/GPU stall|WebGL/.test(text)),
    [],
  );
  await close();
});

test('an IFC and an OBJ that are opened on the desk become GLB and stand in the case, as hawser convert makes them', async () => {
  const ifc = join(folder, 'tunnel.ifc');
  const glb = join(folder, 'tunnel.glb');
  execFileSync('python3', [join(ROOT, 'scripts/tunnel_model.py'), ifc]);
  execFileSync(hawser, ['convert', ifc, '-o', glb, '-q']);
  writeFileSync(join(folder, 'wall.obj'), 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n');
  const { page, heard, close } = await desk();
  page.removeAllListeners('dialog');
  page.on('dialog', (dialog) => dialog.accept(dialog.defaultValue()));
  const opened = async (path) => {
    const download = page.waitForEvent('download');
    await page.locator('#file').setInputFiles(path);
    const saved = join(folder, 'saved.glb');
    await (await download).saveAs(saved);
    return readFileSync(saved);
  };
  assert.ok((await opened(ifc)).equals(readFileSync(glb)));
  await page.waitForFunction(() => /environment:/.test(window.hawserDesk.current()));
  assert.match(await textOf(page), /- file: "tunnel\.glb"/);
  // the second one does not take the place of the first
  await opened(join(folder, 'wall.obj'));
  await page.waitForFunction(() => /wall\.glb/.test(document.querySelector('#status')?.textContent ?? ''));
  assert.match(await textOf(page), /- file: "tunnel\.glb"/);
  assert.deepEqual(heard, []);
  await close();
});
