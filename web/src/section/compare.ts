// Several runs beside each other: what differs in a table, curves together.
import { labels, togetherFigures } from '../chart/together';
import type { Context } from '../context';
import type { RunData, Value } from '../data';
import { el, named } from '../dom';
import { extent } from '../figure/align';
import { csvTools, type DataTable } from '../figure/table';
import { inWords, limitUnit, numbers, standing, texts } from '../run';
import { digits, scaleOf, UNKNOWN, type Unit } from '../units';
import { section, sign } from './parts';

interface Row {
  label: string;
  unit: Unit;
  values: Value[];
}

interface Group {
  label: string;
  rows: Row[];
}

const largestOf = (run: RunData, column: string): Value => extent(numbers(run.rollers, column) ?? [])?.[1] ?? null;

function keyRows(runs: RunData[]): Row[] {
  const row = (label: string, unit: Unit, pick: (run: RunData) => Value | undefined): Row => ({
    label,
    unit,
    values: runs.map((run) => pick(run) ?? null),
  });
  return [
    row('Pull, steady mean', 'N', (run) => run.summary.pull_force?.steady_mean_N),
    row('Pull, peak', 'N', (run) => run.summary.pull_force?.peak_N),
    row('Pull by the reference theory', 'N', (run) => run.summary.theory?.reference_total_N),
    row('Largest roller load', 'N', (run) => largestOf(run, 'peak_N')),
    row('Speed, steady mean', 'm/s', (run) => run.summary.speed?.steady_m_per_s),
    row('Settled after', 's', (run) => run.summary.speed?.settle_time_s),
  ];
}

/** A row a limit that any of the runs has, with what was found. */
function limitRows(runs: RunData[]): Row[] {
  const rows = new Map<string, Row>();
  for (const run of runs) {
    for (const limit of run.summary.limits ?? []) {
      if (!rows.has(limit.name))
        rows.set(limit.name, { label: inWords(limit.name), unit: limitUnit(limit), values: [] });
    }
  }
  for (const [name, row] of rows) {
    row.values = runs.map((run) => run.summary.limits?.find((limit) => limit.name === name)?.value ?? null);
  }
  return [...rows.values()];
}

function marginRows(runs: RunData[]): Row[] {
  return limitRows(runs).map((row): Row => {
    const margin = (run: RunData): Value =>
      run.summary.limits?.find((limit) => inWords(limit.name) === row.label)?.margin ?? null;
    return {
      label: row.label,
      unit: '%',
      values: runs.map((run) => {
        const share = margin(run);
        return share === null ? null : 100 * share;
      }),
    };
  });
}

/** A row a station that any of the runs has, by its name, with its mean tension. */
function stationRows(runs: RunData[]): Row[] {
  const tables = runs.map((run) => {
    const mean = numbers(run.stations, 'mean_N') ?? [];
    return new Map(texts(run.stations, 'name').map((name, i) => [name, mean[i] ?? null]));
  });
  const names = new Set(tables.flatMap((table) => [...table.keys()]));
  return [...names].map((name) => ({ label: name, unit: 'N', values: tables.map((table) => table.get(name) ?? null) }));
}

function groupsOf(runs: RunData[]): Group[] {
  const groups = [
    { label: 'Key figures', rows: keyRows(runs) },
    { label: 'Limits: what was found', rows: limitRows(runs) },
    { label: 'Limits: margin', rows: marginRows(runs) },
    { label: 'Stations: mean tension', rows: stationRows(runs) },
  ];
  const there = (row: Row): boolean => row.values.some((value) => value !== null);
  return groups.map(({ label, rows }) => ({ label, rows: rows.filter(there) })).filter(({ rows }) => rows.length > 0);
}

/** Difference from the first run: of percentages in points, of all else in percent of the first. */
function differenceText(row: Row, value: Value): string {
  const first = row.values[0] ?? null;
  if (first === null || value === null) return '';
  const by = row.unit === '%' ? value - first : (100 * (value - first)) / Math.abs(first);
  if (!Number.isFinite(by)) return '';
  const text = digits(by, 2);
  return `${by > 0 ? '+' : ''}${text}\u202f${row.unit === '%' ? 'points' : '%'}`;
}

function rowElement(row: Row, context: Context): HTMLElement {
  const size = Math.max(...row.values.map((value) => Math.abs(value ?? 0)));
  const scale = row.unit === '%' ? { symbol: '%', factor: 1 } : scaleOf(row.unit, context.units, size);
  const cells = row.values.map((value, i) => {
    const text = value === null ? UNKNOWN : digits(value * scale.factor);
    const difference = i === 0 ? '' : differenceText(row, value);
    return el(
      'td',
      { class: value === null ? 'unknown' : 'number' },
      text,
      difference ? el('span', { class: 'difference' }, difference) : null,
    );
  });
  return el('tr', {}, el('th', { scope: 'row' }, named(row.label), scale.symbol ? `, ${scale.symbol}` : ''), ...cells);
}

function dataOf(groups: Group[], names: string[]): DataTable {
  return {
    name: 'hawser-comparison',
    columns: ['group', 'figure', 'unit', ...names].map((label) => ({ label })),
    rows: groups.flatMap((group) => group.rows.map((row) => [group.label, row.label, row.unit, ...row.values])),
  };
}

const GROUP_OPEN = 24;

/** The comparison; null of a single run. */
export function compareSection(context: Context): HTMLElement | null {
  const { runs } = context.data;
  if (runs.length < 2) return null;
  const names = labels(runs);
  const groups = groupsOf(runs);
  const verdicts = runs.map((run) => {
    const now = standing(run);
    const words = {
      safe: 'safe',
      conditional: 'safe only if',
      unsafe: 'not safe',
      untrusted: 'not trusted',
      unjudged: 'not judged',
    };
    return el('td', {}, el('span', { class: `standing-word ${now}` }, sign(now), words[now]));
  });
  const choose = names.map((name, i) => {
    const chosen = context.store.get('run') === i;
    const pick = el(
      'button',
      { type: 'button', class: 'pick', 'aria-pressed': String(chosen), onclick: () => context.store.set('run', i) },
      named(name),
    );
    return el('th', { scope: 'col' }, pick);
  });
  const bodies = groups.map((group) => {
    const heading = el(
      'tr',
      { class: 'group' },
      el('th', { colspan: names.length + 1, scope: 'rowgroup' }, group.label),
    );
    return el('tbody', {}, heading, ...group.rows.slice(0, GROUP_OPEN).map((row) => rowElement(row, context)));
  });
  const cut = groups.some((group) => group.rows.length > GROUP_OPEN);
  const caption = `Differences are from the first run. Choose a run to see all of it below, and in three dimensions.${cut ? ' Long lists are cut; the CSV has all of them.' : ''}`;
  const table = el(
    'table',
    { class: 'compare' },
    el('caption', {}, caption),
    el('thead', {}, el('tr', {}, el('td'), ...choose)),
    el('tbody', {}, el('tr', {}, el('th', { scope: 'row' }, 'Verdict'), ...verdicts)),
    ...bodies,
  );
  const scroll = el(
    'div',
    { class: 'scroll', tabindex: 0, role: 'region', 'aria-label': 'Comparison of the runs' },
    table,
  );
  const figures = togetherFigures(runs).map((figure) => context.figure(figure));
  return section(
    'compare',
    'Comparison',
    scroll,
    csvTools(() => dataOf(groups, names)),
    ...figures,
  );
}
