// Rows of summary.json: made by tests/house/check_columns.py from the tables of io/results/summary_json.c.

import type { Value } from './data';

export interface LimitRow {
  name: string;
  value: Value;
  limit: Value;
  unit: string;
  margin: Value;
  ok: boolean | null;
  where: string;
  source: string;
  error: Value;
  worst: Value;
  assumed: string;
  friction_most: Value;
  friction_least: Value;
  friction_at_rest_most: Value;
  back_tension_most_N: Value;
  slope_radius_least_m: Value;
}

export interface Trust {
  name: string;
  value: Value;
  allowed: Value;
  unit: string;
  holds: boolean | null;
  remedy: string;
}

export interface EventRow {
  time_s: Value;
  what: string;
  pull_N: Value;
}

export interface Assumption {
  key: string;
  value: string;
  origin: string;
  source: string;
}

export interface ErrorBar {
  time_N: Value;
  mesh_N: Value;
  friction_N: Value;
  total_N: Value;
}

export interface Pass {
  accuracy: Value;
  segments: number;
  v_s_factor: Value;
  steady_mean_N: Value;
  steady_mean_bar_N: Value;
  peak_N: Value;
  peak_bar_N: Value;
  steps: number;
  wall_time_s: Value;
}

export interface Passes {
  outcome: string;
  why: string;
  says: string;
  pass?: Pass[];
}
