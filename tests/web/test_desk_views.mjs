// The desk's views: plan with handles, what if, variants, catalogue, equipment, languages, units, keyboard.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { join } from 'node:path';
import test, { after } from 'node:test';
import { ROOT, stop } from './browser.mjs';
import { desk, differing, drag, middleOf, put, read, settled, textOf } from './desk.mjs';

after(stop);

const duct = read('docs/tutorial/duct.yaml');
test('a handle goes where it is drawn: the length by the way along, the angle by the straight behind it', async () => {
  const { page, close } = await desk();
  await put(page, duct);
  const scale = await page.evaluate(() => {
    const [, length] = /M0 -5V0H([\d.]+)/.exec(document.querySelector('.plan .ruler path').getAttribute('d'));
    return Number(length) / Number.parseFloat(document.querySelector('.plan .ruler text').textContent);
  });
  await drag(page, 'field: length', -40, 0);
  const length = Number(/field, {2}straight: ([\d.]+) m/.exec(await textOf(page))[1]);
  assert.ok(Math.abs(length - (150 - 40 / scale)) < 0.11, `${length} m at ${scale} px/m`);
  await put(page, duct);
  // the middle of the road about the corner: what the pointer turns through is what the bend turns more
  const [x, y] = await middleOf(page, 'corner: angle');
  const [cx, cy] = await middleOf(page, 'field: length');
  const before = (Math.atan2(y - cy, x - cx) * 180) / Math.PI;
  await drag(page, 'corner: angle', 10, 30);
  const turned = (Math.atan2(y + 30 - cy, x + 10 - cx) * 180) / Math.PI - before;
  const angle = Number(/corner, bend: (\d+) deg/.exec(await textOf(page))[1]);
  assert.ok(Math.abs(angle - 45 - turned) < 2.5, `${angle} deg, the pointer turned by ${turned}`);
  await close();
});

test('handles by keys: one press is one step and one undo, the focus stays', async () => {
  const { page, close } = await desk();
  await put(page, duct);
  const handle = page.getByRole('slider', { name: 'bridge: angle' });
  await handle.focus();
  await page.keyboard.press('ArrowUp');
  await settled(page);
  assert.ok((await textOf(page)).includes('bend: 91 deg'));
  assert.equal(await page.evaluate(() => document.activeElement.getAttribute('aria-label')), 'bridge: angle');
  await page.keyboard.press('ArrowDown');
  await settled(page);
  assert.equal(await textOf(page), duct);
  // keys are faster than theory: each counts
  for (let i = 0; i < 3; i++) await page.keyboard.press('ArrowUp');
  assert.ok((await textOf(page)).includes('bend: 93 deg'));
  await settled(page);
  await close();
});

test('pits, machines and rollers slide along the route; corners by coordinates move in plan and height', async () => {
  const { page, close } = await desk();
  await put(page, read('cases/theory/planner.yaml'));
  const before = await textOf(page);
  await drag(page, 'pit 1', 0, 0); // a click changes nothing
  assert.equal(await textOf(page), before);
  await page.locator('#plan .handle[aria-label="pit 1"]').first().focus();
  await page.keyboard.press('ArrowRight');
  await settled(page);
  assert.deepEqual(differing(before, await textOf(page)), ['pits: [{name: joint pit, at: 420.1 m, back: 500 N}]']);
  const corners = duct.replace(
    /  pieces:\n(    - .*\n)+/,
    '  radius: 8 m\n  points: [[0 m, 0 m, 0 m], [150 m, 0 m, 0 m], [150 m, 200 m, 4 m], [60 m, 260 m, 4 m]]   # surveyed\n',
  );
  await put(page, corners.replace('  head_at: 426 m\n', '').replace(/chain:\n.*\n/, ''));
  const text = await textOf(page);
  await drag(page, 'corner 2', 12, 0);
  const [line] = differing(text, await textOf(page));
  assert.match(line, /^points: \[\[0 m, 0 m, 0 m\], \[[\d.]+ m, 0 m, 0 m\], .*# surveyed$/);
  await page.locator('#plan .strip .handle[aria-label="corner 3: height"]').focus();
  await page.keyboard.press('ArrowUp');
  await settled(page);
  assert.match(await textOf(page), /200 m, 4\.1 m\]/);
  await close();
});

test('a place that is pointed at is marked in table, text, plan, profile, tension and sidewall', async () => {
  const { page, close } = await desk();
  await page.click('#tab-route');
  await page.locator('#route tr[data-listed="4"] input').first().focus();
  const marks = () =>
    page.evaluate(() => [
      document.querySelector('#route tr.marked')?.dataset.listed,
      document.querySelectorAll('#plan .pointer[visibility="visible"]').length,
      document.querySelector('.reading').textContent.includes('(bridge)'),
    ]);
  assert.deepEqual(await marks(), ['4', 4, true]);
  await page.click('#tab-text');
  const strip = await page.locator('#plan .strip').nth(1).boundingBox();
  await page.mouse.move(strip.x + 0.6 * strip.width, strip.y + 60);
  assert.match(await page.textContent('.cm-line.marked'), /name: road/);
  await close();
});

test('a clothoid and a parabola among the pieces have columns in the table and handles for their lengths', async () => {
  const { page, heard, close } = await desk();
  const given = read('cases/spiral-drift.yaml');
  await put(page, given);
  await page.click('#tab-route');
  assert.equal(await page.getByLabel('Clothoid, piece 2').inputValue(), '5 m');
  assert.equal(await page.getByLabel('Radius at its end, piece 2').inputValue(), '8 m');
  assert.equal(await page.getByLabel('Slope at its end, piece 5').inputValue(), '0 deg');
  // what a piece cannot have is no field
  assert.equal(await page.getByLabel('Bend, piece 2').isDisabled(), true);
  assert.equal(await page.getByLabel('Turns, piece 1').isDisabled(), true);
  for (const [place, name, from, to] of [
    ['plan', 'in: length', 'clothoid: 5 m, end', 'clothoid: 5.1 m, end'],
    ['profile', 'levels out: length', 'parabola: 4 m', 'parabola: 4.1 m'],
  ]) {
    await page.getByRole('slider', { name, exact: true }).focus();
    await page.keyboard.press('ArrowRight');
    await settled(page);
    assert.equal(await textOf(page), given.replace(from, to), place);
    await page.keyboard.press('Control+z');
    await settled(page);
  }
  await drag(page, 'in: length', 15, 0);
  const [line, ...others] = differing(given, await textOf(page));
  assert.match(line, /^- \{name: in, clothoid: (?!5 m)[\d.]+ m, end_radius: 8 m, plane: left\}$/);
  assert.deepEqual(others, []);
  assert.deepEqual(heard, []);
  await close();
});

test('the first screen has the verdicts of its examples; the table of variants fits at 900 px', async () => {
  const { page, close } = await desk({ start: true, viewport: { width: 900, height: 900 } });
  await page.waitForFunction(() =>
    [...document.querySelectorAll('#start .chip')].every((one) => one.textContent !== ''),
  );
  const chips = await page.locator('#start .chip').allTextContents();
  assert.deepEqual(chips, ['NOT SAFE', 'SAFE', 'NOT SAFE', 'NOT JUDGED', 'NOT SAFE', 'SAFE']);
  // any straight of the first example may be made shorter
  await page.getByRole('button', { name: /A cable in a duct/ }).click();
  await page.getByLabel('Straight, piece 1').fill('20 m');
  await page.keyboard.press('Enter');
  await settled(page);
  assert.equal(await page.textContent('#verdict'), 'SAFE ONLY IF', await page.textContent('#words'));
  await page.click('#tab-variants');
  await settled(page);
  const wide = page.locator('#variants .wide');
  assert.ok(await wide.evaluate((one) => one.scrollWidth <= one.clientWidth));
  await close();
});

test('what if: a slider calculates and writes nothing until the button does; undo', async () => {
  const { page, close } = await desk();
  await put(page, duct);
  await page.click('#tab-whatif');
  const slider = page.getByRole('slider', { name: 'friction (friction.mu)' });
  await slider.fill('0.15');
  await page.waitForFunction(() => /SAFE/.test(document.querySelectorAll('.compare td')[2].textContent));
  assert.equal(await textOf(page), duct);
  const cells = await page.locator('.compare tbody td').allTextContents();
  assert.deepEqual(cells.slice(0, 3), ['NOT SAFE', 'SAFE', '20.8\u00a0kN']);
  await page.getByRole('button', { name: 'Write into the case' }).click();
  await settled(page);
  assert.equal(await textOf(page), duct.replace('mu: 0.3', 'mu: 0.15'));
  assert.equal(await page.textContent('#verdict'), 'SAFE');
  await close();
});

test('variants: kept, judged, opened and copied', async () => {
  const { page, close } = await desk();
  await put(page, duct);
  await page.click('#tab-variants');
  await page.getByLabel('Name of the variant').fill('as drawn');
  await page.getByRole('button', { name: 'Keep the case' }).click();
  await page.evaluate((text) => window.hawserDesk.open(text), duct.replace('mu: 0.3', 'mu: 0.15'));
  await settled(page);
  await page.waitForFunction(() => !document.querySelector('#variants').textContent.includes('…'));
  const rows = await page.locator('#variants tbody tr').allInnerTexts();
  assert.match(rows[0], /The case as it stands\s+SAFE\s/);
  assert.match(
    rows[1],
    /as drawn\s+NOT SAFE\s+20\.8\skN\s+16\.59\skN\s+2\.401\skN\/m\s+428\.8 m \(yard\) – tension: 10\.0 % over/,
  );
  await page.getByRole('button', { name: 'Open: as drawn' }).click();
  await settled(page);
  assert.equal(await textOf(page), duct);
  await page.getByRole('button', { name: 'Copy the table' }).click();
  assert.match(await page.textContent('#status'), /clipboard/);
  await close();
});

test('cable and duct: cross-section, and a type of the catalogue in place of what was written', async () => {
  const { page, close } = await desk();
  await put(page, read('cases/three-in-a-duct.yaml'));
  await page.click('#tab-duct');
  await page.waitForSelector('.entry');
  assert.equal(await page.locator('#duct .ducts circle').count(), 4); // the duct and a cradle of three
  assert.match(await page.innerText('#duct .cross'), /jam ratio\s+3\.44 \(very small risk of jamming\)/);
  await page.selectOption('#duct select[aria-label="Kind"]', 'ducts');
  await page.getByLabel('Search the catalogue').fill('200 sdr11');
  await page.getByRole('button', { name: 'Use pe-200-sdr11' }).click();
  await settled(page);
  assert.match(
    await textOf(page),
    /ducts: \[\{name: duct, place: resting, friction: \{mu: 0\.25\}, type: pe-200-sdr11\}\]/,
  );
  assert.match(await page.innerText('#duct .cross'), /inside 0\.1616 m/);
  await close();
});

test('equipment by rule and one by one, with loads; taken out again', async () => {
  const { page, close } = await desk();
  await put(page, read('docs/tutorial/tunnel.yaml'));
  const before = await textOf(page);
  await page.click('#tab-equipment');
  assert.match(await page.innerText('#equipment .list'), /roller\s+R1\s+1\sm\s+206\sN\s+1\skN\s+79\.4 %/);
  await page.getByLabel('at', { exact: true }).fill('12.5 m');
  await page.getByRole('button', { name: 'Add a machine' }).click();
  await settled(page);
  assert.equal(await textOf(page), `${before}theory:\n  machines:\n    - {at: 12.5 m, push: 5 kN}\n`);
  await page.getByRole('button', { name: 'Add a row' }).click();
  await settled(page);
  assert.ok(
    (await textOf(page)).includes('- {where: straights, spacing: 2 m, radius: 60 mm, width: 400 mm, rating: 5 kN}'),
  );
  await page.getByRole('button', { name: 'Remove: Row of rollers 4' }).click();
  await settled(page);
  assert.equal(await textOf(page), `${before}theory:\n  machines:\n    - {at: 12.5 m, push: 5 kN}\n`);
  await close();
});

test('units and language are remembered; the address and the case choose a language', async () => {
  const { page, close } = await desk();
  await page.selectOption('#units', 'us');
  await page.selectOption('#language', 'de');
  await settled(page);
  assert.match(await page.textContent('#words'), /^Vorwärts gezogen: 4675\slbf/);
  await page.reload();
  await settled(page);
  assert.match(await page.textContent('#words'), /^Vorwärts gezogen: 4675\slbf/);
  const language = () => page.evaluate(() => document.documentElement.lang);
  assert.equal(await language(), 'de');
  // the address wins over what was chosen
  await page.goto(`${page.url()}#zh`);
  await page.reload();
  await settled(page);
  assert.equal(await language(), 'zh');
  await close();
  const fresh = await desk();
  assert.equal(await fresh.page.evaluate(() => document.documentElement.lang), 'en');
  const given = duct.replace('cables:', 'job: {language: de}\ncables:');
  await fresh.page.setInputFiles('#file', { name: 'de.yaml', mimeType: 'text/yaml', buffer: Buffer.from(given) });
  await fresh.page.waitForFunction(() => document.getElementById('name').textContent === 'de.yaml');
  await settled(fresh.page);
  assert.equal(await fresh.page.evaluate(() => document.documentElement.lang), 'de');
  await fresh.close();
});

/** Words of English that no name or unit is; keys of a case, which have points or underlines in them, stand as they are. */
const ENGLISH =
  /\b(the|of|and|with|is|at|case|route|pulled|forward|limits?|broken|allowed|verdict|safe|add|remove|piece|friction|tension|height|search|use)\b/i;
const english = (text) => ENGLISH.exec(text.replace(/[\w-]+([._][\w-]+)+/g, ''))?.[0];

test('no English is left on the desk in Chinese and German', async () => {
  const { page, close } = await desk();
  for (const language of ['zh', 'de']) {
    await page.selectOption('#language', language);
    for (const name of ['docs/tutorial/duct', 'cases/limits', 'cases/three-in-a-duct', 'cases/theory/planner']) {
      await put(
        page,
        read(`${name}.yaml`)
          .replace(/^title:.*$/m, 'title: T')
          .replace(/name: [^,}]*/g, 'name: N'),
      );
      for (const [left, right] of [
        ['text', 'plan'],
        ['route', 'whatif'],
        ['values', 'variants'],
        ['duct', 'help'],
        ['equipment', 'page'],
      ]) {
        await page.click(`#tab-${left}`);
        await page.click(`#tab-${right}`);
        await page.waitForTimeout(100);
        const found = await page.evaluate(() => {
          const words = [];
          const walk = (node, inside) => {
            if (node.nodeType === 3) words.push([node.textContent, inside]);
            if (node.nodeType !== 1 || node.hidden || node.closest('[lang=en], code, .cm-editor, script, style, #name, #help input ~ dl'))
              return;
            // keys and words of a case stand as they are
            if (
              node.matches('#values span, #values legend, .knob span, #remedies button, option[value]') &&
              !node.dataset.t
            )
              return;
            for (const key of ['aria-label', 'title', 'placeholder'])
              if (node.hasAttribute(key) && !node.closest('#values, .knob, #remedies') && !node.matches('[lang=en]'))
                words.push([node.getAttribute(key), key]);
            for (const child of node.childNodes) walk(child, node.tagName);
          };
          document.documentElement.lang = '';
          walk(document.body, '');
          const page = document.getElementById('page');
          if (!page.hidden) words.push([page.contentDocument?.body.innerText ?? '', 'page']);
          return words.filter(([text]) => text.trim());
        });
        const bad = found.flatMap(([text, where]) => (english(text) ? [`${english(text)} in ${where}: ${text}`] : []));
        assert.deepEqual(bad.slice(0, 5), [], `${name}, ${language}, ${left} and ${right}`);
      }
    }
    // the meaning of every key, a few at a time, as the list of help shows them
    await page.click('#tab-help');
    const schema = JSON.parse(execFileSync(process.argv[2], ['schema'], { encoding: 'utf8' }));
    const named = [...Object.keys(schema.properties), ...Object.keys(schema.$defs)];
    const seen = new Map();
    for (const section of named) {
      await page.fill('#help input[type=search]', section);
      const shown = await page.$$eval('#help input ~ dl > *', (all) => all.map((one) => one.textContent));
      for (let i = 0; i < shown.length; i += 2) seen.set(shown[i], shown[i + 1]);
    }
    assert.ok(seen.size > 500, `${seen.size} keys`);
    const rest = [...seen].filter(([, words]) =>
      /\b(the|of|and|with|is|which|when)\b/i.test(words.replace(/`[^`]*`/g, '')),
    );
    assert.deepEqual(rest.slice(0, 5), [], language);
    assert.deepEqual(await page.evaluate(() => window.hawserDesk.withoutRow()), []);
  }
  await close();
});

test('from a surveyor’s table to a printed report without typing YAML, in less than 25 actions', async () => {
  const { page, heard, close } = await desk();
  let actions = 0;
  const act = async (what) => {
    actions++;
    await what;
    await settled(page);
  };
  await act(page.setInputFiles('#file', join(ROOT, 'cases/theory/route-table.csv')));
  await page.waitForFunction(() => window.hawserDesk.current().includes('route-table.csv'));
  await act(page.click('#tab-duct'));
  await act(page.getByLabel('Search the catalogue').fill('110kv 800 cu'));
  await act(
    page
      .getByRole('button', { name: /^Use xlpe-110kv-800-cu/ })
      .first()
      .click(),
  );
  await act(page.selectOption('#duct select[aria-label="Kind"]', 'ducts'));
  await act(page.getByLabel('Search the catalogue').fill('pe-225 sdr11'));
  await act(page.getByRole('button', { name: 'Use pe-225-sdr11' }).click());
  assert.match(await page.textContent('#status'), /limits\.conductor|^$/);
  await act(page.click('#tab-values'));
  for (const [key, value] of [
    ['title', 'Substation to harbour'],
    ['friction.mu', '0.15'],
  ]) {
    await act(page.getByLabel(key, { exact: true }).fill(value));
    await act(page.keyboard.press('Enter'));
  }
  await act(page.click('#tab-page'));
  assert.notEqual(await page.textContent('#verdict'), 'NOT A CASE YET', await page.textContent('#words'));
  const printed = await page.evaluate(() => {
    const frame = document.getElementById('page').contentWindow;
    return new Promise((done) => {
      frame.print = () => done(frame.document.body.innerText);
      document.getElementById('print').click();
    });
  });
  actions++;
  assert.match(printed, /^Pulling calculation: Substation to harbour/);
  assert.match(printed, /allowed 48 kN[^]*under the sewer/);
  assert.match(await textOf(page), /power: \{type: xlpe-110kv-800-cu/);
  assert.ok(actions < 25, `${actions} actions`);
  assert.deepEqual(heard, []);
  await close();
});

test('the line of a file is written into the case as a plan with a profile, whose lines, arcs and corners have handles', async () => {
  const { page, close } = await desk();
  await page.setInputFiles('#file', join(ROOT, 'cases/theory/route-table.csv'));
  await page.waitForFunction(() => window.hawserDesk.current().includes('route-table.csv'));
  await settled(page);
  const theory = async () =>
    JSON.parse(await page.evaluate(() => window.hawserDesk.theory(window.hawserDesk.current())));
  const before = await theory();
  assert.equal(await page.locator('#plan .handle').count(), 0);
  await page.click('#tab-route');
  await page.getByRole('button', { name: 'Write the line of the file into the case' }).click();
  await page.waitForFunction(() => window.hawserDesk.current().includes('plan:'));
  await settled(page);
  const text = await textOf(page);
  assert.ok(text.includes('- {arc: 9.424777961 m, radius: 12 m, turn: left, name: "gate bend"}'), text);
  const now = await theory();
  for (const key of ['length_m', 'largest_force_N', 'backward_largest_force_N', 'max_sidewall_N_per_m'])
    assert.ok(Math.abs(now[key] / before[key] - 1) < 1e-7, `${key}: ${now[key]} and ${before[key]}`);
  // handles stand where the engine's line is
  const off = await page.evaluate(() => {
    const d = document
      .querySelector('.plan .route')
      .getAttribute('d')
      .slice(1)
      .split('L')
      .map((pair) => pair.split(' ').map(Number));
    return [...document.querySelectorAll('.plan .handle')].map((one) => {
      const [x, y] = /translate\(([-\d.]+) ([-\d.]+)\)/.exec(one.getAttribute('transform')).slice(1).map(Number);
      return Math.min(...d.map(([px, py]) => Math.hypot(px - x, py - y)));
    });
  });
  assert.ok(off.length > 20 && Math.max(...off) < 1, `${off.length} handles, off by ${Math.max(...off)} px`);
  await drag(page, 'street: length', 10, 5);
  assert.match(differing(text, await textOf(page)).join(), /^- \{line: [\d.]+ m, name: "street"\}$/);
  await page.keyboard.press('Control+z');
  assert.equal(await textOf(page), text);
  await settled(page);
  await page.getByRole('slider', { name: 'gate bend: radius' }).focus();
  await page.keyboard.press('ArrowUp');
  await settled(page);
  assert.match(
    differing(text, await textOf(page)).join(),
    /^- \{arc: 9\.503 m, radius: 12\.1 m, turn: left, name: "gate bend"\}$/,
  );
  await page.keyboard.press('Control+z');
  await settled(page);
  await page.getByRole('slider', { name: 'gate bend: angle' }).focus();
  await page.keyboard.press('ArrowUp');
  await settled(page);
  assert.match(
    differing(text, await textOf(page)).join(),
    /^- \{arc: 9\.634 m, radius: 12 m, turn: left, name: "gate bend"\}$/,
  );
  await page.keyboard.press('Control+z');
  await settled(page);
  await page.getByRole('slider', { name: 'Profile, corner 3' }).focus();
  await page.keyboard.press('ArrowDown');
  await settled(page);
  assert.match(differing(text, await textOf(page)).join(), /^- \{station: 79\.5 m, height: -3\.9 m, radius: 20 m\}$/);
  assert.notEqual(await page.textContent('#verdict'), 'NOT A CASE YET');
  await close();
});
