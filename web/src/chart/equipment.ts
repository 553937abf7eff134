// Figures of what drives the cable: conveyors, driven rollers, the reel.
import type { RunData, Value } from '../data';
import { ORDER } from '../figure/palette';
import type { FigureSpec, Role } from '../figure/spec';
import type { Unit } from '../units';
import { timeFigure, type Column } from './over_time';

type Machine = Record<string, Value | string>;

/** Columns NAME_suffix of the machines that reach most, at most as many as curves can be told apart. */
function columnsOf(machines: Machine[], suffix: string, size: string): { columns: Column[]; left: number } {
  const ranked = [...machines].sort((a, b) => Math.abs(Number(b[size] ?? 0)) - Math.abs(Number(a[size] ?? 0)));
  const shown = new Set(ranked.slice(0, ORDER.length));
  const columns = machines
    .filter((machine) => shown.has(machine))
    .map((machine, i) => ({
      name: `${String(machine['name'])}_${suffix}`,
      label: String(machine['name']),
      role: ORDER[i] as Role,
    }));
  return { columns, left: machines.length - columns.length };
}

function machineFigure(
  run: RunData,
  machines: Machine[],
  what: { id: string; title: string; caption: string; suffix: string; size: string; label: string; unit: Unit },
): FigureSpec | null {
  const { columns, left } = columnsOf(machines, what.suffix, what.size);
  const note = left > 0 ? ` The ${columns.length} largest; ${left} more are in the table of machines.` : '';
  return timeFigure(run, what.id, what.title, what.caption + note, what.label, what.unit, columns);
}

const present = (figures: (FigureSpec | null)[]): FigureSpec[] => figures.filter((figure) => figure !== null);

export function conveyorFigures(run: RunData): FigureSpec[] {
  const machines = run.summary.conveyors ?? [];
  return present([
    machineFigure(run, machines, {
      id: 'conveyor-force',
      title: 'Forces of the conveyors',
      caption: 'Force on the cable along the pull.',
      suffix: 'force_N',
      size: 'peak_N',
      label: 'force',
      unit: 'N',
    }),
    machineFigure(run, machines, {
      id: 'conveyor-slip',
      title: 'Slip of the conveyors',
      caption: 'Speed of the cable less that of the belt; 0 where there is no cable.',
      suffix: 'slip_m_per_s',
      size: 'peak_N',
      label: 'slip',
      unit: 'm/s',
    }),
  ]);
}

export function motorFigures(run: RunData): FigureSpec[] {
  const machines = run.summary.motors ?? [];
  return present([
    machineFigure(run, machines, {
      id: 'motor-torque',
      title: 'Torques of the driven rollers',
      caption: 'Torque on the roller, positive with the pull.',
      suffix: 'torque_N_m',
      size: 'peak_N_m',
      label: 'torque',
      unit: 'N m',
    }),
    machineFigure(run, machines, {
      id: 'motor-speed',
      title: 'Speeds of the driven rollers',
      caption: 'Speed of the roller’s surface.',
      suffix: 'speed_m_per_s',
      size: 'peak_N_m',
      label: 'speed',
      unit: 'm/s',
    }),
  ]);
}

export function reelFigures(run: RunData): FigureSpec[] {
  return present([
    timeFigure(run, 'reel-speed', 'Speed of the reel', 'Angular speed of the drum.', 'speed', 'rad/s', [
      { name: 'reel_speed_rad_per_s', label: 'reel', role: 'simulated' },
    ]),
    timeFigure(
      run,
      'reel-cable',
      'Cable on the reel',
      'What has left the drum, and what is still on it.',
      'length',
      'm',
      [
        { name: 'paid_out_m', label: 'paid out', role: 'simulated' },
        { name: 'wound_m', label: 'wound', role: 'second' },
      ],
    ),
  ]);
}
