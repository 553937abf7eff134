// The route piece by piece by theory, as the page of the calculation has it (docs/guide/plan-a-duct.md, "Hand it on").
import type { Context } from '../context';
import { note, recordTable, section, type Field } from './parts';

const NAME: Field = { key: 'name', label: 'piece' };

const PLACE: Field[] = [
  { key: 'from_m', label: 'from', unit: 'm' },
  { key: 'to_m', label: 'to', unit: 'm' },
  { key: 'angle_deg', label: 'angle, °' },
  { key: 'radius_m', label: 'R', unit: 'm' },
  { key: 'turns', label: 'turns' },
  { key: 'slope_deg', label: 'slope, °' },
  { key: 'mu', label: 'friction', unit: '1' },
  { key: 'mu_rest', label: 'at rest', unit: '1' },
];

const pulled = (way: string): Field[] => [
  { key: `${way}_start_N`, label: 'in', unit: 'N' },
  { key: `${way}_end_N`, label: 'out', unit: 'N' },
  { key: `${way}_rest_N`, label: 'from rest', unit: 'N' },
  { key: `${way}_sidewall_N_per_m`, label: 'T/R', unit: 'N/m' },
];

export function piecesSection(context: Context): HTMLElement | null {
  const pieces = context.run.summary.pieces ?? [];
  if (pieces.length === 0) return null;
  // straights have no radius: an empty cell, not an unknown one
  const rows = pieces.map((piece) => Object.fromEntries(Object.entries(piece).map(([key, v]) => [key, v ?? ''])));
  const table = (id: string, caption: string, fields: Field[]) =>
    recordTable(id, caption, rows, [NAME, ...fields], context.units);
  return section(
    'pieces',
    'The route piece by piece',
    note(
      'By theory, full of cable. “in” and “out” are tensions in motion; friction has the weight correction of ducts.',
    ),
    table('pieces', 'Pulled forward', [...PLACE, ...pulled('forward')]),
    table('pieces-back', 'Pulled back', [
      { key: 'to_m', label: 'from', unit: 'm' },
      { key: 'from_m', label: 'to', unit: 'm' },
      ...pulled('back'),
    ]),
  );
}
