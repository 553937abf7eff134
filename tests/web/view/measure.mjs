// Times of the view for a pull of 2000 rollers, 1800 segments and 600 states, in software WebGL: opening, unpacking, script time a picture.
// Prints figures; nothing passes or fails by them.
// Usage: node tests/web/view/measure.mjs [DATA.json]     (data of a page in place of the made-up pull)
import { readFileSync } from 'node:fs';
import { pages } from './pages.mjs';
import { large } from './scenes.mjs';

const data = process.argv[2] ? JSON.parse(readFileSync(process.argv[2], 'utf8')) : large();
const kit = await pages();
const page = await kit.open(kit.write('measured', data));
const opened = await page.evaluate(() => window.hawser.opened());
const times = await page.evaluate(async () => {
  const { viewer } = window.hawser.view;
  const { from, to } = viewer.playback;
  const picture = () => new Promise((done) => requestAnimationFrame(() => setTimeout(done, 0)));
  const middle = (list, share) => list.sort((a, b) => a - b)[Math.floor(share * (list.length - 1))];
  const spent = { update: [], render: [], hover: [] };
  for (let i = 0; i < 100; i++) {
    viewer.seek(from + ((to - from) * ((37 * i) % 100)) / 99.7);
    await picture();
    spent.update.push(viewer.world.stage.spent.update);
    spent.render.push(viewer.world.stage.spent.render);
    const start = performance.now();
    viewer.world.rollerAt(400 + i, 250);
    viewer.world.placeAt(400 + i, 250);
    spent.hover.push(performance.now() - start);
  }
  const start = performance.now();
  viewer.inspect({
    place: viewer.model.path.at ? (viewer.model.path.from + viewer.model.path.to) / 2 : 0,
  });
  const click = performance.now() - start;
  const pairs = Object.entries(spent).map(([name, list]) => [name, [middle(list, 0.5), middle(list, 0.95)]]);
  return { ...Object.fromEntries(pairs), click: [click, click] };
});
console.log(`mounted ${opened.mounted.toFixed(0)} ms, all states there after ${opened.unpacked.toFixed(0)} ms`);
for (const [name, [median, high]] of Object.entries(times))
  console.log(`${name.padEnd(8)} median ${median.toFixed(2)} ms, 95 of 100 below ${high.toFixed(2)} ms`);
await kit.close();
