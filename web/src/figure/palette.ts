// Colours after Okabe and Ito, which the colour-blind tell apart; every curve also differs by its dash, width or marks.
import type { Theme } from '../state';
import type { Role } from './spec';

export interface Palette {
  text: string;
  muted: string;
  grid: string;
  paper: string;
  limit: string;
  event: string;
  window: string;
  band: string;
  curve: Record<Role, string>;
}

const LIGHT: Palette = {
  text: '#1b1f24',
  muted: '#57606a',
  grid: '#e3e7eb',
  paper: '#ffffff',
  limit: '#c04a00',
  event: '#7a5195',
  window: 'rgba(0, 114, 178, 0.07)',
  band: 'rgba(0, 114, 178, 0.16)',
  curve: {
    simulated: '#0072b2',
    peak: '#0072b2',
    envelope: '#5aa9d6',
    theory: '#1b1f24',
    backward: '#8a6d00',
    paper: '#b3437c',
    second: '#c98a00',
    third: '#007f5f',
    fourth: '#b3437c',
    fifth: '#3f8fc0',
    sixth: '#57606a',
    ground: '#57606a',
    route: '#1b1f24',
  },
};

const DARK: Palette = {
  text: '#e6eaee',
  muted: '#9aa5b1',
  grid: '#2b323a',
  paper: '#161b21',
  limit: '#ff8a4c',
  event: '#c3a1dd',
  window: 'rgba(86, 180, 233, 0.09)',
  band: 'rgba(86, 180, 233, 0.22)',
  curve: {
    simulated: '#56b4e9',
    peak: '#56b4e9',
    envelope: '#3b7ea8',
    theory: '#e6eaee',
    backward: '#d9bf4d',
    paper: '#e39ac4',
    second: '#e69f00',
    third: '#2fc59a',
    fourth: '#e39ac4',
    fifth: '#8fc7ea',
    sixth: '#9aa5b1',
    ground: '#9aa5b1',
    route: '#e6eaee',
  },
};

export const palette = (theme: Theme): Palette => (theme === 'dark' ? DARK : LIGHT);

/** Dash in CSS pixels; none is a solid line. */
export const DASH: Record<Role, number[]> = {
  simulated: [],
  peak: [1, 3],
  envelope: [],
  theory: [7, 4],
  backward: [2, 3],
  paper: [9, 3, 2, 3],
  second: [6, 3],
  third: [2, 2],
  fourth: [9, 3, 2, 3],
  fifth: [12, 4],
  sixth: [4, 2, 1, 2],
  ground: [],
  route: [],
};

export const WIDTH: Record<Role, number> = {
  simulated: 2,
  peak: 1.5,
  envelope: 1,
  theory: 1.5,
  backward: 1.5,
  paper: 1.5,
  second: 1.5,
  third: 1.5,
  fourth: 1.5,
  fifth: 1.5,
  sixth: 1.5,
  ground: 1.5,
  route: 1.5,
};

/** Roles for curves that are told apart only by their order. */
export const ORDER: Role[] = ['simulated', 'second', 'third', 'fourth', 'fifth', 'sixth'];
