// The view alone on a page, with its store in the open: for the tests in a browser.
import 'uplot/dist/uPlot.min.css';
import { readData } from '../../../web/src/data';
import { Store } from '../../../web/src/state';
import { mountView } from '../../../web/src/view/view';

const params = new URLSearchParams(location.search);
const store = new Store({
  place: null,
  time: null,
  units: params.get('units') === 'us' ? 'us' : 'si',
  theme: params.get('theme') === 'dark' ? 'dark' : 'light',
  run: 0,
  roller: null,
});
const root = document.getElementById('hawser')!;
const start = performance.now();
const view = mountView(root, readData(document).runs[0]!, store);
const mounted = performance.now() - start;
let unpacked = 0;
void view.ready.then(() => (unpacked = performance.now() - start));
Object.assign(window, {
  hawser: { view, store, opened: () => ({ mounted, unpacked }) },
});
