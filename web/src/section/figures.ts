// Sections that are figures alone: along the route, and over time.
import { curvatureFigure, profileFigure, pushFigure, sidewallFigure, tensionFigure } from '../chart/along';
import { forceFigure, headFigure, speedFigure } from '../chart/over_time';
import type { Context, Section } from '../context';
import { planDrawing } from '../plan/plan';
import { note, section } from './parts';

const OLDER = 'These results are of an older hawser, or of a run that was cut short: compute them again to have it.';

export const alongSection: Section = (context) => {
  const { run } = context;
  const parts: HTMLElement[] = [];
  const tension = tensionFigure(run);
  parts.push(
    tension ? context.figure(tension) : note(`There is no tension along the route in these results. ${OLDER}`),
  );
  const push = pushFigure(run);
  if (push) parts.push(context.figure(push));
  const sidewall = sidewallFigure(run);
  parts.push(
    sidewall
      ? context.figure(sidewall)
      : note(`There is no sidewall pressure along the route in these results. ${OLDER}`),
  );
  const curvature = curvatureFigure(run);
  if (curvature) parts.push(context.figure(curvature));
  return section('along', 'Along the route', ...parts);
};

export const routeSection: Section = (context) => {
  const profile = profileFigure(context.run);
  const plan = planDrawing(context);
  if (!profile || !plan) {
    return section('route', 'Plan and profile', note(`There is no geometry of the route in these results. ${OLDER}`));
  }
  return section('route', 'Plan and profile', plan, context.figure(profile));
};

export const timeSection: Section = (context: Context) => {
  const { run } = context;
  const specs = [forceFigure(run), headFigure(run), speedFigure(run)].filter((figure) => figure !== null);
  if (specs.length === 0) {
    return section('time', 'Over time', note(`There is nothing over time in these results. ${OLDER}`));
  }
  const still = headFigure(run)
    ? null
    : note('The cable’s head does not move along the route in this run, so there is no force over its place.');
  return section('time', 'Over time', ...specs.map((spec) => context.figure(spec)), still);
};
