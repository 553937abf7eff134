// The page in the hands of a reader: pointing, zooming, choosing, comparing, printing, with the mouse and with the keyboard alone.
import assert from 'node:assert/strict';
import test, { after } from 'node:test';
import { column, open, savedCsv, settled, stop } from './browser.mjs';
import { report, run } from './sample.mjs';

after(stop);

const at = (page, id) => page.locator(`#figure-${id} .legend-at`).innerText();

/** Points at a share of the width of a figure's plotting area. */
async function point(page, id, share) {
  const over = page.locator(`#figure-${id} .u-over`);
  await over.scrollIntoViewIfNeeded();
  const box = await over.boundingBox();
  await page.mouse.move(box.x + box.width * share, box.y + box.height / 2);
  await page.waitForTimeout(50);
}

const metres = (text) => Number(/at ([\d.]+)\u00a0(?:m|s)/.exec(text)?.[1]);

test('pointing at a place shows it in all figures along the route and in the plan', async () => {
  const { page, close } = await open(report(run()));
  await point(page, 'tension', 0.5);
  const place = metres(await at(page, 'tension'));
  assert.ok(Math.abs(place - 20) < 0.2, `${place} m in the middle of 40 m`);
  for (const id of ['sidewall', 'curvature', 'profile', 'rollers']) {
    assert.equal(metres(await at(page, id)), place, id);
    const x = await page
      .locator(`#figure-${id} .u-cursor-x`)
      .evaluate((line) => new DOMMatrix(getComputedStyle(line).transform).e);
    assert.ok(x > 0, `cursor in ${id}`);
  }
  assert.match(await page.locator('.plan-pointer').getAttribute('d'), /^M/);
  assert.match(await page.locator('#figure-tension .legend').innerText(), /steady mean\s+6\.0\d+\u00a0kN/);
  await page.mouse.move(2, 2);
  await page.waitForTimeout(50);
  assert.equal(await at(page, 'sidewall'), '');
  await close();
});

test('pointing at the plan shows the place in the figures', async () => {
  const { page, close } = await open(report(run()));
  const route = page.locator('.plan .plan-route');
  await route.scrollIntoViewIfNeeded();
  const box = await route.boundingBox();
  await page.mouse.move(box.x + 2, box.y + box.height - 2);
  await page.waitForTimeout(50);
  const start = metres(await at(page, 'profile'));
  assert.ok(start < 1.5, `${start} m at the route's beginning`);
  await close();
});

test('pointing at a time shows it in all figures over time, and in the one over the head’s place', async () => {
  const { page, close } = await open(report(run()));
  await point(page, 'force', 0.25);
  const time = metres(await at(page, 'force'));
  assert.ok(Math.abs(time - 5) < 0.1, `${time} s`);
  for (const id of ['speed', 'conveyor-force', 'reel-cable']) assert.equal(metres(await at(page, id)), time, id);
  assert.ok(Math.abs(metres(await at(page, 'head')) - (10 + 1.5 * time)) < 0.2, 'head');
  await page.locator('#events button').nth(1).click();
  assert.equal(metres(await at(page, 'speed')), 7.5);
  await close();
});

test('a figure zooms by dragging and is whole again after a double click', async () => {
  const { page, close } = await open(report(run()));
  const over = page.locator('#figure-tension .u-over');
  await over.scrollIntoViewIfNeeded();
  const box = await over.boundingBox();
  await page.mouse.move(box.x + box.width * 0.25, box.y + 40);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width * 0.75, box.y + 60, { steps: 4 });
  await page.mouse.up();
  assert.match(await page.locator('#figure-tension').getAttribute('class'), /zoomed/);
  await point(page, 'tension', 0.999);
  assert.ok(Math.abs(metres(await at(page, 'tension')) - 30) < 0.5, 'the right end is at 30 m');
  await over.dblclick({ position: { x: 50, y: 50 } });
  assert.doesNotMatch(await page.locator('#figure-tension').getAttribute('class'), /zoomed/);
  await close();
});

test('the keyboard alone points, zooms, switches units and opens tables', async () => {
  const { page, close } = await open(report(run()));
  const reach = async (found) => {
    for (let i = 0; i < 200; i += 1) {
      await page.keyboard.press('Tab');
      if (await page.evaluate(found)) return;
    }
    assert.fail(`not reached by Tab: ${found}`);
  };
  await reach(() => document.activeElement.getAttribute('name') === 'units');
  await page.keyboard.press('ArrowRight');
  assert.match(await page.locator('#key-figures').innerText(), /lbf/);
  await page.keyboard.press('ArrowLeft');
  await settled(page);
  await reach(
    () => document.activeElement.closest('#figure-tension') && document.activeElement.classList.contains('frame'),
  );
  await page.keyboard.press('Home');
  await page.keyboard.press('Shift+ArrowRight');
  assert.equal(metres(await at(page, 'sidewall')), 4);
  await page.keyboard.press('+');
  assert.match(await page.locator('#figure-tension').getAttribute('class'), /zoomed/);
  await page.keyboard.press('0');
  assert.doesNotMatch(await page.locator('#figure-tension').getAttribute('class'), /zoomed/);
  await reach(() => document.activeElement.textContent === 'Table');
  await page.keyboard.press('Enter');
  assert.equal(await page.locator('#figure-tension table').count(), 1);
  await close();
});

test('headings are in order, and everything that acts or shows has a name', async () => {
  const { page, close } = await open(report(run(), run('second', 2)));
  const levels = await page
    .locator('h1, h2, h3, h4')
    .evaluateAll((all) => all.map((heading) => Number(heading.tagName[1])));
  levels.forEach((level, i) =>
    assert.ok(i === 0 ? level === 1 : level <= levels[i - 1] + 1, `heading ${i}: h${level}`),
  );
  const nameless = await page
    .locator('button, select, input, svg[role=img], [tabindex="0"]')
    .evaluateAll((all) =>
      all
        .filter(
          (one) => !(one.getAttribute('aria-label') || one.textContent.trim() || one.labels?.[0]?.textContent.trim()),
        )
        .map((one) => one.outerHTML.slice(0, 80)),
    );
  assert.deepEqual(nameless, []);
  await close();
});

test('several runs: differences in a table, curves together, one of them chosen', async () => {
  const { page, heard, close } = await open(report(run(), run('second', 2), run('third', 0.5)));
  const row = page.locator('#compare tr', { hasText: 'Pull, steady mean' });
  assert.deepEqual(await row.locator('td').allInnerTexts(), ['8', '16\n+100\u202f%', '4\n\u221250\u202f%']);
  const rows = await savedCsv(page, '#compare');
  assert.deepEqual(rows[0].slice(3), ['first', 'second', 'third']);
  const together = await savedCsv(page, '#figure-together-force');
  const [first, second] = ['first', 'second'].map((label) => column(together, label));
  first.forEach((value, i) => assert.ok(Math.abs(second[i] - 2 * value) < 1e-6));
  await page.locator('#compare thead').getByRole('button', { name: 'second' }).click();
  assert.match(await page.locator('#key-figures').innerText(), /16\u00a0kN/);
  assert.equal(await page.locator('#run-choice').inputValue(), '1');
  assert.deepEqual(heard, []);
  await close();
});

test('prints on A4 and Letter with static figures in colours for paper', async () => {
  const { page, close } = await open(report(run()), { colorScheme: 'dark' });
  await page.evaluate(() =>
    addEventListener('beforeprint', () => (globalThis.printed = document.querySelectorAll('.paper-figure').length)),
  );
  for (const format of ['A4', 'Letter']) {
    const pdf = await page.pdf({ format, printBackground: true });
    const [, width] = /MediaBox \[0 0 ([\d.]+)/.exec(pdf.toString('latin1'));
    assert.ok(Math.abs(Number(width) - (format === 'A4' ? 595.9 : 612)) < 1, `${format}: ${width}`);
    assert.equal(await page.evaluate(() => globalThis.printed), await page.locator('.plot').count());
  }
  assert.equal(await page.locator('.paper-figure').count(), 0, 'gone after the print');
  await close();
});

test('the plan has a table, and sentences follow the units', async () => {
  const { page, close } = await open(report(run()));
  assert.ok((await savedCsv(page, '#figure-plan')).length > 81, 'all points of the route and what stands on it');
  await page.getByText('US', { exact: true }).click();
  assert.match(await page.locator('#verdict').innerText(), /at 56\.1\u00a0ft \(bend\)/);
  await close();
});

test('light and dark follow the reader’s system, and the switch', async () => {
  const { page, close } = await open(report(run()), { colorScheme: 'dark' });
  const ground = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  assert.equal(await ground(), 'rgb(14, 18, 22)');
  await page.getByText('Light', { exact: true }).click();
  assert.equal(await ground(), 'rgb(244, 246, 248)');
  await page.emulateMedia({ colorScheme: 'light' });
  // The page hears of a change with its next picture: of two in between of none.
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  await page.emulateMedia({ colorScheme: 'dark' });
  await page.waitForFunction(() => document.documentElement.dataset.theme === 'dark');
  assert.ok(await page.getByLabel('Dark').isChecked());
  await close();
});

test('fits a phone, a tablet and a desk', async () => {
  for (const width of [390, 900, 1440]) {
    const { page, close } = await open(report(run(), run('second', 2)), { viewport: { width, height: 800 } });
    const beyond = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
    assert.ok(beyond <= 0, `${width} px: ${beyond} px too wide`);
    await close();
  }
});
