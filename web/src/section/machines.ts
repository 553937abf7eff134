// Conveyors, driven rollers, the reel, ducts and other surfaces: only those that the run has.
import { conveyorFigures, motorFigures, reelFigures } from '../chart/equipment';
import type { Context, Section } from '../context';
import type { FigureSpec } from '../figure/spec';
import { recordTable, section, type Field } from './parts';

const CONVEYOR: Field[] = [
  { key: 'name', label: 'conveyor' },
  { key: 'from_m', label: 'from', unit: 'm' },
  { key: 'to_m', label: 'to', unit: 'm' },
  { key: 'grip_N', label: 'largest force', unit: 'N' },
  { key: 'reference_N', label: 'theory reckons with', unit: 'N' },
  { key: 'steady_mean_N', label: 'steady mean', unit: 'N' },
  { key: 'peak_N', label: 'peak', unit: 'N' },
  { key: 'belt_m_per_s', label: 'belt', unit: 'm/s' },
  { key: 'slip_m_per_s', label: 'slip', unit: 'm/s' },
  { key: 'slipping', label: 'share of time slipping', unit: '1' },
];

const MOTOR: Field[] = [
  { key: 'name', label: 'driven roller' },
  { key: 'at_m', label: 'place', unit: 'm' },
  { key: 'limit_N_m', label: 'set or largest torque', unit: 'N m' },
  { key: 'reference_N', label: 'theory reckons with', unit: 'N' },
  { key: 'steady_mean_N_m', label: 'steady mean', unit: 'N m' },
  { key: 'peak_N_m', label: 'peak', unit: 'N m' },
  { key: 'surface_m_per_s', label: 'surface', unit: 'm/s' },
  { key: 'power_W', label: 'power', unit: 'W' },
  { key: 'at_limit', label: 'share of time at its limit', unit: '1' },
];

const SURFACE: Field[] = [
  { key: 'name', label: 'surface' },
  { key: 'kind', label: 'kind' },
  { key: 'from_m', label: 'from', unit: 'm' },
  { key: 'to_m', label: 'to', unit: 'm' },
  { key: 'clearance_m', label: 'clearance', unit: 'mm' },
  { key: 'jam_ratio', label: 'jam ratio', unit: '1' },
  { key: 'steady_normal_N', label: 'normal force, steady mean', unit: 'N' },
  { key: 'steady_friction_N', label: 'friction, steady mean', unit: 'N' },
  { key: 'peak_line_load_N_per_m', label: 'largest force per length', unit: 'N/m' },
  { key: 'peak_line_load_error', label: 'off by at most', unit: 'N/m' },
  { key: 'peak_at_m', label: 'at', unit: 'm' },
];

function figures(context: Context, specs: FigureSpec[]): HTMLElement[] {
  return specs.map((spec) => context.figure(spec));
}

export const conveyorsSection: Section = (context) => {
  const machines = context.run.summary.conveyors ?? [];
  if (machines.length === 0) return null;
  const table = recordTable('conveyors', 'Conveyors', machines, CONVEYOR, context.units);
  return section('conveyors', 'Conveyors', table, ...figures(context, conveyorFigures(context.run)));
};

export const motorsSection: Section = (context) => {
  const machines = context.run.summary.motors ?? [];
  if (machines.length === 0) return null;
  const table = recordTable('motors', 'Driven rollers', machines, MOTOR, context.units);
  return section('motors', 'Driven rollers', table, ...figures(context, motorFigures(context.run)));
};

export const reelSection: Section = (context) => {
  const specs = reelFigures(context.run);
  return specs.length > 0 ? section('reel', 'Reel', ...figures(context, specs)) : null;
};

export const surfacesSection: Section = (context) => {
  const surfaces = context.run.summary.surfaces ?? [];
  if (surfaces.length === 0) return null;
  return section(
    'surfaces',
    'Ducts, trays and walls',
    recordTable('surfaces', 'Surfaces', surfaces, SURFACE, context.units),
  );
};
