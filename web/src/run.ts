// Questions about one run that several parts of the page ask.
import type { Columns, Limit, RunData, Value } from './data';
import type { Level, Mark } from './figure/spec';
import { isUnit, type Unit } from './units';

/** A column of numbers; null if the table or the column is not there. Text in it counts as not known. */
export function numbers(table: Columns | null | undefined, name: string): Value[] | null {
  const column = table?.[name];
  if (!Array.isArray(column)) return null;
  return column.map((value) => (typeof value === 'number' && Number.isFinite(value) ? value : null));
}

export function texts(table: Columns | null | undefined, name: string): string[] {
  const column = table?.[name];
  return Array.isArray(column) ? column.map((value) => String(value ?? '')) : [];
}

/** Whether anything in the column is known. */
export function known(values: Value[] | null | undefined): values is Value[] {
  return !!values && values.some((value) => value !== null && value !== undefined);
}

const LIMIT_NAMES: Record<string, string> = {
  pull: 'Tension in the cable',
  attachment: 'Tension at eye or net',
  sidewall: 'Sidewall pressure',
  bend_radius: 'Bend radius of the cable',
  rope_bend: 'Bend of the rope, over its diameter',
  roller_steady: 'Roller load, steady',
  roller_peak: 'Roller load, peak',
  rope: 'Pull of the rope',
  winch: 'Pull of the winch',
  push: 'Force of a conveyor',
  buckling: 'Push, against buckling',
  squeeze: 'Clamp of a conveyor',
  run_away: 'Brake that is missing',
  alpha: 'Overload factor',
  trip: 'Trip of the winch',
  speed: 'Speed of the pull',
  jam_ratio: 'Jam ratio',
  clearance: 'Clearance in the duct',
  clearance_environment: 'Clearance from the environment',
  fill: 'Fill of the duct',
  weight_correction: 'Weight correction factor',
  restart: 'Restart from rest',
};

/** A limit's or a condition's name in words. */
export function inWords(name: string): string {
  const words = LIMIT_NAMES[name] ?? name.replaceAll('_', ' ');
  return words.charAt(0).toUpperCase() + words.slice(1);
}

/** The unit in which a limit is shown: small lengths in millimetres. */
export function limitUnit(limit: { name: string; unit: string }): Unit {
  if (limit.name.startsWith('clearance')) return 'mm';
  return isUnit(limit.unit) ? limit.unit : '1';
}

/** Limits that were judged, the smallest margin first. */
export function judged(run: RunData): Limit[] {
  const limits = (run.summary.limits ?? []).filter((limit) => limit.ok !== null && limit.margin !== null);
  return limits.sort((a, b) => (a.margin ?? 0) - (b.margin ?? 0));
}

export function limitNamed(run: RunData, name: string): Limit | null {
  return run.summary.limits?.find((limit) => limit.name === name) ?? null;
}

/** A limit as a line across a figure; none if it is not known. */
export function levels(run: RunData, ...names: string[]): Level[] {
  return names.flatMap((name) => {
    const value = limitNamed(run, name)?.limit;
    return typeof value === 'number' ? [{ label: `allowed (${inWords(name).toLowerCase()})`, value }] : [];
  });
}

export function marks(run: RunData): Mark[] {
  return (run.summary.events ?? []).map((event) => ({ x: event.time_s, label: event.what }));
}

/** The steady window where the run reached it. */
export function steadyWindow(run: RunData): { from: number; to: number; label: string } | undefined {
  const { from_s: from, to_s: to } = run.summary.steady_window ?? {};
  return typeof from === 'number' && typeof to === 'number' && to > from
    ? { from, to, label: 'steady window' }
    : undefined;
}

/** A remedy as the program words it; empty where it knows none. */
export function remedyOf(limit: Limit): string {
  return limit.remedy ?? '';
}

export type Standing = 'safe' | 'conditional' | 'unsafe' | 'untrusted' | 'unjudged';

/** What the verdict says, by its first words. */
export function standing(run: RunData): Standing {
  const verdict = run.summary.verdict ?? '';
  if (verdict.startsWith('NOT TRUSTED')) return 'untrusted';
  if (verdict.startsWith('NOT SAFE')) return 'unsafe';
  if (verdict.startsWith('SAFE ONLY IF')) return 'conditional';
  if (verdict.startsWith('SAFE')) return 'safe';
  return 'unjudged';
}

export function title(run: RunData): string {
  return run.summary.title || run.summary.case || run.label;
}
