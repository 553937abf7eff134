// Two hundred random edits through table, plan and text: the three show the same, and the program says what the desk says.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import test, { after } from 'node:test';
import { stop } from './browser.mjs';
import { assertSame, desk, put, read, settled, textOf } from './desk.mjs';

const hawser = process.argv[2];
const folder = mkdtempSync(join(tmpdir(), 'hawser-desk-'));
after(async () => {
  rmSync(folder, { recursive: true });
  await stop();
});

let seed = 11;
const draw = (n) => (seed = (seed * 48271) % 2147483647) % n;

const NAMES = ['straight', 'bend', 'radius', 'plane'];

/** A value of a kind that a case may have. */
const value = {
  straight: () => `${5 + draw(90)} m`,
  bend: () => `${10 + draw(80)} deg`,
  radius: () => `${4 + draw(20)} m`,
  plane: () => ['left', 'right'][draw(2)],
};

async function byTable(page) {
  const rows = await page.locator('#route tbody tr').count();
  const row = page.locator('#route tbody tr').nth(draw(rows));
  const key = NAMES[draw(4)];
  const input = row.locator('input').nth(1 + NAMES.indexOf(key));
  if (!(await input.inputValue())) return; // a straight gets no radius
  await input.fill(value[key]());
  await input.press('Enter');
}

async function byPlan(page) {
  await page.click('#plan [aria-label="Show all"]');
  const knobs = page.locator('#plan .plan .handle .knob');
  const box = await knobs.nth(draw(await knobs.count())).boundingBox();
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 5, y + 5);
  await page.mouse.move(x + draw(31) - 15, y + draw(31) - 15);
  await page.mouse.up();
}

async function byText(page) {
  await page.evaluate(
    ([n, next]) =>
      window.hawserDesk.type((text) => {
        const found = [...text.matchAll(/(?<=straight: )[^,}]+/g)];
        const one = found[n % found.length];
        return [one.index, one.index + one[0].length, next];
      }),
    [draw(50), value.straight()],
  );
}

/** What the three show: values of the pieces by the text, by the table, by the handles of the plan. */
const shown = (page) =>
  page.evaluate(() => {
    const text = window.hawserDesk.current();
    const pieces = [...text.matchAll(/- \{name: (\w+), *(.*?)\}/g)].map(([, name, rest]) => [
      name,
      Object.fromEntries(rest.split(/, */).map((pair) => pair.split(/: */))),
    ]);
    const table = [...document.querySelectorAll('#route tbody tr')].map((row) => {
      const [name, ...values] = [...row.querySelectorAll('input')].map((input) => input.value);
      const keys = ['straight', 'bend', 'radius', 'plane', 'slope'];
      return [name, Object.fromEntries(keys.flatMap((key, i) => (values[i] ? [[key, values[i]]] : [])))];
    });
    const key = { length: 'straight', radius: 'radius', angle: 'bend' };
    const wrong = [...document.querySelectorAll('#plan .plan .handle')].flatMap((handle) => {
      const [name, what] = handle.getAttribute('aria-label').split(': ');
      const now = handle.getAttribute('aria-valuetext');
      const own = pieces.find(([one]) => one === name)?.[1][key[what]];
      return own === now ? [] : [`${name} ${what}: ${now}, ${own}`];
    });
    return { pieces, table, wrong, handles: document.querySelectorAll('#plan .plan .handle').length };
  });

test('two hundred random edits through table, plan and text', async () => {
  const { page, heard, close } = await desk();
  await put(
    page,
    `# kept\n${read('docs/tutorial/duct.yaml')
      .replace(/ *head_at.*\n/, '')
      .replace(/chain:\n.*\n/, '')}# the end\n`,
  );
  await page.click('#tab-route');
  let changes = 0;
  for (let i = 0; i < 200; i++) {
    const before = await textOf(page);
    await [byTable, byPlan, byText][draw(3)](page);
    await settled(page);
    const after = await textOf(page);
    const lines = before.split('\n').filter((line, k) => line !== after.split('\n')[k]);
    assert.ok(lines.length <= 1, `edit ${i} changed ${lines.join(' | ')}`);
    changes += lines.length;
    const { pieces, table, wrong, handles } = await shown(page);
    assert.deepEqual(table, pieces, `edit ${i}`);
    assert.deepEqual(wrong, [], `edit ${i}`);
    assert.ok(handles >= 5, `edit ${i}: ${handles} handles`);
    if (i % 20 !== 19) continue;
    const file = join(folder, 'case.yaml');
    writeFileSync(file, after);
    const said = spawnSync(hawser, ['theory', file, '--format', 'json'], { encoding: 'utf8' });
    assert.equal(said.status, 0, said.stderr);
    assertSame(
      JSON.parse(await page.evaluate((words) => window.hawserDesk.theory(words), after)),
      JSON.parse(said.stdout),
    );
  }
  const last = await textOf(page);
  assert.ok(last.startsWith('# kept\n') && last.endsWith('# the end\n'));
  assert.ok(changes > 150, `${changes} of 200 edits changed something`);
  assert.deepEqual(heard, []);
  await close();
});
