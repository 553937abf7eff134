// More of the desk: random edits, comments and line ends, accessibility, narrow screens, what is handed on.
import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import test, { after } from 'node:test';
import { openFile, ROOT, stop } from './browser.mjs';
import { assertSame, desk, put, read, settled, textOf } from './desk.mjs';

const hawser = process.argv[2];
after(stop);

test('two hundred random edits: the table shows the text, and the program reads it as the desk does', async () => {
  const { page, close } = await desk();
  let seed = 7;
  const draw = (n) => (seed = (seed * 48271) % 2147483647) % n;
  await put(page, read('docs/tutorial/duct.yaml').replace(/ *head_at.*\n/, ''));
  const shown = await page.evaluate(
    (random) => {
      const desk = window.hawserDesk;
      const wrong = [];
      for (const [kind, place, value] of random) {
        document.getElementById('tab-route').click();
        const rows = [...document.querySelectorAll('#route tbody tr')];
        const row = rows[place % rows.length];
        const lines = desk.current().split('\n');
        if (kind < 6) {
          const names = ['name', 'straight', 'bend', 'radius', 'plane', 'slope'];
          const input = row.querySelectorAll('input')[kind];
          if (!input.value) continue; // a straight gets no radius
          const next = {
            name: `p${value}`,
            straight: `${value + 5} m`,
            bend: `${value + 10} deg`,
            radius: `${value + 4} m`,
            plane: value % 2 ? 'left' : 'right',
          }[names[kind]];
          if (!next) continue;
          input.value = next;
          input.dispatchEvent(new Event('change'));
          const now = desk.current().split('\n');
          if (now.length !== lines.length || now.filter((line, i) => line !== lines[i]).length > 1)
            wrong.push(`${names[kind]}: more than a line`);
          if (
            document.querySelectorAll('#route tbody tr')[place % rows.length].querySelectorAll('input')[kind].value !==
            next
          )
            wrong.push(`${names[kind]}: not shown`);
        } else {
          const buttons = row.querySelectorAll('button');
          if (kind === 8 && rows.length < 3) continue;
          buttons[kind - 6].click();
          const change = document.querySelectorAll('#route tbody tr').length - rows.length;
          if (change !== (kind === 8 ? -1 : 1)) wrong.push(`button ${kind}: ${change} rows`);
        }
      }
      return wrong;
    },
    Array.from({ length: 200 }, () => [draw(9), draw(50), draw(60)]),
  );
  assert.deepEqual(shown, []);
  await settled(page);
  const text = await textOf(page);
  const file = join(mkdtempSync(join(tmpdir(), 'hawser-desk-')), 'case.yaml');
  writeFileSync(file, text);
  const said = spawnSync(hawser, ['theory', file, '--format', 'json'], { encoding: 'utf8' });
  rmSync(dirname(file), { recursive: true });
  const got = await page.evaluate((words) => window.hawserDesk.theory(words).catch((why) => why.message), text);
  if (said.status === 0) assertSame(JSON.parse(got), JSON.parse(said.stdout));
  else assert.ok(said.stderr.includes(got.replace(/^case\.yaml/, '')), `${got} and ${said.stderr}`);
  await close();
});

test('it can be used on a narrow screen', async () => {
  const { page, close } = await desk({ viewport: { width: 390, height: 844 } });
  for (const language of ['en', 'zh', 'de']) {
    await page.selectOption('#language', language);
    for (const tab of ['text', 'route', 'values', 'duct', 'equipment', 'plan', 'whatif', 'variants', 'page', 'help']) {
      await page.click(`#tab-${tab}`);
      const wide = await page.evaluate(() => document.documentElement.scrollWidth);
      assert.ok(wide <= 390, `${tab}, ${language}: ${wide} px wide`);
    }
  }
  await close();
});

test('hawser desk CASE has the case in it, whatever stands in its text, and writes over no case', async () => {
  const folder = mkdtempSync(join(tmpdir(), 'hawser-desk-'));
  const [file, page_file] = [join(folder, 'evil.yaml'), join(folder, 'desk.html')];
  const text = `# </script><script>alert(1)</script> <!-- ü \u2028\n${read('cases/limits.yaml')}`;
  writeFileSync(file, text);
  execFileSync(hawser, ['desk', file, '-q', '-o', page_file]);
  const { page, heard, close } = await openFile(page_file, {}, settled);
  assert.equal(await textOf(page), text);
  assert.equal(await page.textContent('#name'), 'evil.yaml');
  assert.equal(await page.textContent('#verdict'), 'NOT SAFE');
  assert.deepEqual(heard, []);
  await close();
  // the files that it names are there when it opens
  writeFileSync(join(folder, 'line #1.csv'), read('cases/theory/route-table.csv'));
  const named = read('docs/tutorial/duct.yaml').replace(/^route:[^]*?(?=^\w)/m, 'route: {file: "line #1.csv"}\n');
  writeFileSync(file, named);
  execFileSync(hawser, ['desk', file, '-q', '-o', page_file]);
  const whole = await openFile(page_file, {}, settled);
  assert.notEqual(await whole.page.textContent('#verdict'), 'NOT A CASE YET', await whole.page.textContent('#words'));
  assert.deepEqual(whole.heard, []);
  await whole.close();
  assert.equal(spawnSync(hawser, ['desk', file, '-q', '-o', file]).status, 2);
  assert.equal(readFileSync(file, 'utf8'), named);
  assert.equal(spawnSync(hawser, ['desk', join(folder, 'none.yaml'), '-q', '-o', page_file]).status, 2);
  rmSync(folder, { recursive: true });
});

test('keys that may stand at the cursor are offered, with what they are', async () => {
  const { page, close } = await desk();
  await put(
    page,
    'cables: {c: {d: 80 mm, mass: 9 kg/m}}\nroute: {pieces: [{straight: 100 m}]}\nsurfaces:\n  ducts:\n    - radius: 70 mm\n      \n',
  );
  const offered = async (line) => {
    await page.evaluate((n) => window.hawserDesk.cursor(n), line);
    await page.keyboard.press('Control+Space');
    await page.waitForSelector('.cm-tooltip-autocomplete li');
    const labels = await page.locator('.cm-tooltip-autocomplete .cm-completionLabel').allTextContents();
    await page.keyboard.press('Escape');
    return labels;
  };
  const duct = await offered(6);
  assert.ok(duct.includes('friction') && duct.includes('from') && !duct.includes('cables'), duct.join());
  const top = await offered(7);
  assert.ok(top.includes('limits') && top.includes('theory') && !top.includes('radius'), top.join());
  await close();
});

test('nothing serious for those who hear it or use the keyboard alone (axe-core)', async () => {
  for (const colorScheme of ['light', 'dark']) {
    const { page, close } = await desk({ colorScheme });
    await page.evaluate(readFileSync(join(ROOT, 'web/node_modules/axe-core/axe.min.js'), 'utf8'));
    for (const tab of ['text', 'route', 'values', 'duct', 'equipment', 'plan', 'whatif', 'variants', 'page', 'help']) {
      await page.click(`#tab-${tab}`);
      await page.waitForTimeout(50);
      const found = await page.evaluate(() => window.axe.run(document, { iframes: false }));
      const serious = found.violations.filter((one) => ['serious', 'critical'].includes(one.impact));
      assert.deepEqual(
        serious.map((one) => `${tab}, ${colorScheme}: ${one.id} ${one.nodes[0].html.slice(0, 120)}`),
        [],
      );
    }
    await close();
  }
});

test('what is shown and saved is of the text as it stands; of several chains the worst is shown', async () => {
  const { page, close } = await desk();
  const of = (name) => page.evaluate((id) => document.getElementById(id).disabled, name);
  await page.evaluate(() => window.hawserDesk.open(window.hawserDesk.current().replace('mu: 0.3', 'mu: 0.15')));
  assert.ok((await of('save-page')) && (await page.textContent('#remedies')) === '');
  await settled(page);
  assert.ok(!(await of('save-page')));
  await put(page, (await textOf(page)).replace('mu: 0.15', 'mu: zzz'));
  assert.ok(await of('save-page'));
  assert.equal(await page.evaluate(() => document.getElementById('page').srcdoc), '');
  const chains = read('cases/bundles/second-circuit.yaml');
  await put(page, chains.replace(/^limits:.*\n(^ .*\n)*/m, '') + '\nlimits: {pull: 450 N}\n');
  const said = JSON.parse(await page.evaluate(() => window.hawserDesk.theory(window.hawserDesk.current())));
  const codes = Object.values(said.theory).map((one) => one.verdict_code);
  assert.ok(codes.includes('not_safe'), codes.join());
  assert.equal(await page.textContent('#verdict'), 'NOT SAFE');
  assert.match(await page.textContent('#words'), /^Of \d chains the worst: /);
  await close();
});

test('one remedy of several keys is one button; a planner’s example is safe with it', async () => {
  const { page, close } = await desk();
  await put(page, read('cases/theory/planner.yaml'));
  const buttons = await page.locator('#remedies button').allTextContents();
  assert.equal(buttons.filter((text) => text.includes('mu')).length, 1, buttons.join(' | '));
  await page.locator('#remedies button').first().click();
  await settled(page);
  assert.match(await page.textContent('#verdict'), /^SAFE/);
  await close();
});

test('block YAML, comments and line ends stay as they are', async () => {
  const { page, close } = await desk();
  const block = [
    '# a case',
    'title:',
    'cables: {c: {d: 80 mm, mass: 9 kg/m}}',
    'route:',
    '  pieces:',
    '    # the well-known yard',
    '    - straight: 40 m # forty',
    '      name: yard',
    '    # before the bend',
    '    - bend: 45 deg',
    '      radius: 8 m',
    '      plane: left',
    '    # last',
    '    - {straight: 60 m} # tail',
    '# ducts',
    'surfaces: {ducts: [{radius: 70 mm, friction: {mu: 0.2}}]}',
    '',
  ].join('\r\n');
  await page.setInputFiles('#file', { name: 'block.yaml', mimeType: 'text/yaml', buffer: Buffer.from(block) });
  await page.waitForFunction(() => window.hawserDesk.current().startsWith('# a case'));
  await settled(page);
  assert.equal(await page.textContent('#name'), 'block.yaml');
  await page.click('#tab-route');
  await page.getByLabel('Take piece 1 out').click();
  let lines = (await textOf(page)).split('\n');
  assert.deepEqual(lines.slice(4, 8), [
    '  pieces:',
    '    # the well-known yard',
    '    # before the bend',
    '    - bend: 45 deg',
  ]);
  await page.keyboard.press('Control+z');
  await page.getByLabel('Add a straight behind piece 3').click();
  lines = (await textOf(page)).split('\n');
  assert.deepEqual(lines.slice(13, 16), ['    - {straight: 60 m} # tail', '    - {straight: 10 m}', '# ducts']);
  await page.keyboard.press('Control+z');
  await page.getByLabel('Radius, piece 2').fill('9 m');
  await page.keyboard.press('Tab');
  await page.waitForTimeout(50);
  assert.equal(await page.evaluate(() => document.activeElement.getAttribute('aria-label')), 'Turns, piece 2');
  await page.click('#tab-values');
  await page.getByLabel('title').fill('Bay # 7');
  await page.keyboard.press('Enter');
  assert.equal((await textOf(page)).split('\n')[1], 'title: "Bay # 7"');
  const [download] = await Promise.all([page.waitForEvent('download'), page.click('#save')]);
  const expected = block.replace('title:', 'title: "Bay # 7"').replace('radius: 8 m', 'radius: 9 m');
  assert.equal(readFileSync(await download.path(), 'utf8'), expected);
  await close();
});
