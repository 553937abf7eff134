// What stands behind the figures: conditions of trust, inputs, and what made them.
import type { Section } from '../context';
import type { Assumption, Input, Passes, Trust } from '../data';
import { el, named } from '../dom';
import { csvTools } from '../figure/table';
import { inWords } from '../run';
import type { UnitSystem } from '../state';
import { digits, isUnit, sentenceText, show, UNKNOWN, type Unit } from '../units';
import { fact, note, recordTable, section, sign, type Field } from './parts';

function scrolled(label: string, table: HTMLElement): HTMLElement {
  return el('div', { class: 'scroll', tabindex: 0, role: 'region', 'aria-label': label }, table);
}

function heads(...labels: string[]): HTMLElement {
  return el('thead', {}, el('tr', {}, ...labels.map((text) => el('th', { scope: 'col' }, text))));
}

const PASS: Field[] = [
  { key: 'which', label: 'pass' },
  { key: 'segments', label: 'segments', unit: '1' },
  { key: 'accuracy', label: 'accuracy', unit: '1' },
  { key: 'v_s_factor', label: 'speed at which friction comes in, of the case’s', unit: '1' },
  { key: 'steady_mean_N', label: 'pull, steady mean', unit: 'N' },
  { key: 'steady_mean_bar_N', label: '± by itself', unit: 'N' },
  { key: 'peak_N', label: 'pull, peak', unit: 'N' },
  { key: 'peak_bar_N', label: '± by itself', unit: 'N' },
  { key: 'steps', label: 'steps', unit: '1' },
  { key: 'wall_time_s', label: 'computed in', unit: 's' },
];

/** Why a run was computed again, or would have been, what came of it, and what each pass found. */
function passesPart(passes: Passes, units: UnitSystem): HTMLElement[] {
  const each = passes.pass ?? [];
  const shown = passes.outcome === 'replaced' ? each.length - 1 : 0;
  const rows = each.map((pass, i) => ({
    which: `${['first', 'second', 'third'][i] ?? i + 1}${i === shown ? ', shown' : ''}`,
    ...pass,
  }));
  const said = `${passes.why}: ${passes.says}.`;
  return [
    el('h3', {}, 'Passes'),
    el('p', {}, named(sentenceText(said.charAt(0).toUpperCase() + said.slice(1), units))),
    recordTable('passes', 'What each pass found before it knew of the others.', rows, PASS, units),
  ];
}

export const trustSection: Section = ({ run, units }) => {
  const conditions = run.summary.trust;
  if (!conditions)
    return section(
      'trust',
      'Can these figures be trusted?',
      note('These results hold no conditions of trust: they are of an older hawser.'),
    );
  const failed = conditions.filter((condition) => condition.holds === false).length;
  const answer =
    failed === 0
      ? `Yes: all ${conditions.length} conditions hold.`
      : `No: ${failed} of ${conditions.length} conditions ${failed === 1 ? 'does' : 'do'} not hold.`;
  const shown = (value: number | null, unit: string): string =>
    value === null ? UNKNOWN : isUnit(unit) ? show(value, unit, units, 3) : `${digits(value, 3)} ${unit}`;
  const row = (condition: Trust): HTMLElement => {
    const standing = condition.holds === false ? 'unsafe' : condition.holds ? 'safe' : 'unjudged';
    const word = condition.holds === false ? 'fails' : condition.holds ? 'holds' : 'not judged';
    return el(
      'tr',
      { class: standing },
      el('th', { scope: 'row' }, inWords(condition.name)),
      el('td', { class: 'standing' }, el('span', { class: `standing-word ${standing}` }, sign(standing), word)),
      el('td', { class: 'number' }, shown(condition.value, condition.unit)),
      el('td', { class: 'number' }, shown(condition.allowed, condition.unit)),
      el('td', { class: 'source' }, condition.holds === false ? named(sentenceText(condition.remedy, units)) : null),
    );
  };
  const order = [...conditions].sort((a, b) => Number(a.holds !== false) - Number(b.holds !== false));
  const table = el(
    'table',
    {},
    el('caption', {}, 'Conditions under which the run is worth judging.'),
    heads('Condition', 'Standing', 'Found', 'Allowed', 'What to do'),
    el('tbody', {}, ...order.map(row)),
  );
  return section(
    'trust',
    'Can these figures be trusted?',
    el('p', {}, answer),
    scrolled('Conditions of trust', table),
    ...(run.summary.passes ? passesPart(run.summary.passes, units) : []),
  );
};

const ORIGIN: Record<string, string> = {
  given: 'given in the case',
  catalogue: 'from the catalogue',
  estimated: 'estimated',
  default: 'default',
};

/** All inputs; of results without them the values that the case did not say itself. */
function inputRows(inputs: Input[] | null | undefined, assumptions: Assumption[] = []): string[][] {
  const sources = new Map(assumptions.map(({ key, source }) => [key, source]));
  if (inputs)
    return inputs.map(({ key, value, origin, where }) => [key, value, origin, where || sources.get(key) || '']);
  return assumptions.map(({ key, value, origin, source }) => [key, value, origin, source]);
}

export const inputsSection: Section = ({ run }) => {
  const rows = inputRows(run.inputs, run.summary.assumptions);
  const heading = 'Inputs and assumptions';
  if (rows.length === 0) {
    return section('inputs', heading, note('These results hold no list of inputs. The case file has them.'));
  }
  const count = new Map<string, number>();
  for (const row of rows) count.set(row[2] ?? '', (count.get(row[2] ?? '') ?? 0) + 1);
  const counts = [...count].map(([origin, n]) => `${n} ${ORIGIN[origin] ?? origin}`).join(', ');
  const line = ([key = '', value = '', origin = '', where = '']: string[]): HTMLElement =>
    el(
      'tr',
      { class: `origin-${/^\w+$/.test(origin) ? origin : 'other'}` },
      el('th', { scope: 'row', class: 'key' }, named(key)),
      el('td', {}, named(value)),
      el('td', {}, el('span', { class: 'origin' }, ORIGIN[origin] ?? named(origin))),
      el('td', { class: 'source' }, named(where)),
    );
  const table = el(
    'table',
    { class: 'inputs' },
    el('caption', {}, 'As they were read, with their units as in the case.'),
    heads('Input', 'Value', 'Origin', 'Where from'),
    el('tbody', {}, ...rows.map(line)),
  );
  const data = () => ({
    name: 'hawser-inputs',
    columns: ['input', 'value', 'origin', 'where from'].map((label) => ({ label })),
    rows,
  });
  const estimated = rows.filter((row) => row[2] === 'estimated' || row[2] === 'catalogue');
  const open = estimated.length > 0 ? `Not from the case itself: ${estimated.length}. Check these first.` : '';
  return section(
    'inputs',
    heading,
    el('p', {}, `${rows.length} values: ${counts}. ${open}`),
    el(
      'details',
      { class: 'long', open: rows.length <= 40 },
      el('summary', {}, 'All values'),
      scrolled('Inputs', table),
    ),
    csvTools(data),
  );
};

export const aboutSection: Section = ({ run, data, units }) => {
  const { summary } = run;
  const text = (value: string | undefined): HTMLElement => (value ? named(value) : el('span', {}, UNKNOWN));
  const number = (key: string, unit: Unit): string => show(summary[key] as number | null | undefined, unit, units);
  const facts = [
    fact('Case', text(summary.case)),
    fact('Results', text(run.label)),
    fact('Simulated with', text(summary.version && `hawser ${summary.version}`)),
    fact('Report by', text(data.hawser && `hawser ${data.hawser}`), data.generated ? named(data.generated) : ''),
    fact('Simulated time', number('sim_time_s', 's')),
    fact('Segments', number('segments', '1')),
    fact('Steps', number('steps', '1')),
    fact('Computed in', number('wall_time_s', 's')),
    fact('Outcome', text(summary.outcome), summary.message ? named(summary.message) : ''),
  ];
  return section('about', 'Versions', el('dl', { class: 'facts small' }, ...facts));
};

export const eventsSection: Section = ({ run, units, store }) => {
  const events = run.summary.events ?? [];
  if (events.length === 0) return null;
  const jump = (time: number) => () => store.set('time', time);
  const items = events.map((event) =>
    el(
      'li',
      {},
      el('button', { type: 'button', class: 'pick', onclick: jump(event.time_s) }, show(event.time_s, 's', units)),
      ' ',
      named(sentenceText(event.what, units)),
      event.pull_N === null ? '' : `, pull ${show(event.pull_N, 'N', units)}`,
    ),
  );
  return section('events', 'Events', el('ol', { class: 'events' }, ...items));
};
