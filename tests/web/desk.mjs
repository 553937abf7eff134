// The desk from disk, for the tests of it.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { openFile, ROOT } from './browser.mjs';

/** Until what is on the screen is of the text as it stands. */
export const settled = (page) =>
  page.waitForFunction(
    () =>
      document.getElementById('verdict').textContent !== '' &&
      document.getElementById('answer').getAttribute('aria-busy') === 'false' &&
      window.hawserDesk.idle(),
  );

/** The desk with the example that is on it at first; `start`: the screen of examples stays. */
export async function desk({ start = false, ...options } = {}) {
  const opened = await openFile(join(ROOT, 'web/dist/desk.html'), options, settled);
  opened.page.on('dialog', (dialog) => dialog.accept());
  if (!start) await opened.page.keyboard.press('Escape');
  return opened;
}

export const textOf = (page) => page.evaluate(() => window.hawserDesk.current());

export async function put(page, text) {
  await page.evaluate((words) => window.hawserDesk.open(words), text);
  await settled(page);
}

export const read = (path) => readFileSync(join(ROOT, path), 'utf8');

/** Equal texts; numbers within 1e-9 of the larger of two. What is next to nothing (a slope of 1e-15) has no digits. */
export function assertSame(got, expected, place = '') {
  if (typeof expected === 'number') {
    const size = Math.max(Math.abs(got), Math.abs(expected));
    assert.ok(Math.abs(got - expected) <= 1e-9 * size + 1e-12, `${place}: ${got} and ${expected}`);
  } else if (expected && typeof expected === 'object') {
    assert.deepEqual(Object.keys(got), Object.keys(expected), place);
    for (const key of Object.keys(expected)) assertSame(got[key], expected[key], `${place}.${key}`);
  } else {
    assert.equal(got, expected, place);
  }
}

/** Lines that differ. */
export const differing = (a, b) => {
  const [before, after] = [a.split('\n'), b.split('\n')];
  assert.equal(after.length, before.length);
  return before.flatMap((line, i) => (line === after[i] ? [] : [after[i].trim()]));
};

export async function middleOf(page, label) {
  const box = await page.locator(`#plan .plan .handle[aria-label="${label}"] .knob`).boundingBox();
  return [box.x + box.width / 2, box.y + box.height / 2];
}

/** Drags a handle of the plan by so many pixels, in steps as a hand does. */
export async function drag(page, label, dx, dy) {
  const [x, y] = await middleOf(page, label);
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (let i = 1; i <= 5; i++) await page.mouse.move(x + (dx * i) / 5, y + (dy * i) / 5);
  await page.mouse.up();
  await settled(page);
}
