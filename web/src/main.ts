// Reads the data that hawser wrote into the page, and makes the page of them.
import 'uplot/dist/uPlot.min.css';
import './report.css';
import { readData } from './data';
import { el } from './dom';
import { live } from './live';
import { Page } from './page';
import { Store, type Theme } from './state';

function start(root: HTMLElement): void {
  const dark = matchMedia('(prefers-color-scheme: dark)');
  const theme: Theme = dark.matches ? 'dark' : 'light';
  const store = new Store({ place: null, time: null, units: 'si', theme, run: 0, roller: null });
  const show = (): void => void (document.documentElement.dataset['theme'] = store.get('theme'));
  show();
  store.subscribe('theme', show);
  dark.addEventListener('change', () => store.set('theme', dark.matches ? 'dark' : 'light'));
  new Page(root, readData(document), store);
}

// The desk shows a run with it while it is computed (src/desk/simulate.ts).
Object.assign(window, { hawserLive: live });

const root = document.getElementById('hawser');
if (root) {
  try {
    start(root);
  } catch (error) {
    root.replaceChildren(
      el('p', { class: 'failed', role: 'alert' }, error instanceof Error ? error.message : String(error)),
    );
    throw error;
  }
}
