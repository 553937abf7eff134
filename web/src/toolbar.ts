// What the reader chooses for the whole page: run, units, colours, print.
import { labels } from './chart/together';
import { button, el } from './dom';
import type { ReportData } from './data';
import type { State, Store } from './state';

/** A group of which one is chosen. */
function choice<K extends 'units' | 'theme'>(
  store: Store,
  key: K,
  label: string,
  options: [State[K], string][],
): HTMLElement {
  const inputs = options.map(([value, text]) => {
    const input = el('input', {
      type: 'radio',
      name: key,
      value,
      checked: store.get(key) === value,
      onchange: () => store.set(key, value),
    });
    store.subscribe(key, (now) => (input.checked = now === value));
    return el('label', {}, input, el('span', {}, text));
  });
  return el('fieldset', { class: 'choice' }, el('legend', {}, label), ...inputs);
}

export function toolbar(data: ReportData, store: Store): HTMLElement {
  const units = choice(store, 'units', 'Units', [
    ['si', 'Metric'],
    ['us', 'US'],
  ]);
  const theme = choice(store, 'theme', 'Colours', [
    ['light', 'Light'],
    ['dark', 'Dark'],
  ]);
  const bar = el('div', { class: 'toolbar', role: 'toolbar', 'aria-label': 'The page' });
  if (data.runs.length > 1) {
    const select = el('select', { id: 'run-choice', onchange: () => store.set('run', Number(select.value)) });
    labels(data.runs).forEach((label, i) => select.append(el('option', { value: i }, label.slice(0, 60))));
    store.subscribe('run', (run) => (select.value = String(run)));
    bar.append(el('label', { class: 'run-choice' }, 'Run ', select));
  }
  bar.append(
    units,
    theme,
    button('Print', () => print(), { class: 'print' }),
  );
  return bar;
}
