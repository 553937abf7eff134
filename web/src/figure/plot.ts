// A figure on the screen: a specification becomes a uPlot.
import uPlot from 'uplot';
import type { Theme, UnitSystem } from '../state';
import { scaleOf, type Scale } from '../units';
import { align, extent, type Aligned } from './align';
import { overlay } from './overlay';
import { DASH, palette, WIDTH } from './palette';
import { levelsShown, roomy, tickLabels, ticks } from './ranges';
import { X_UNIT, type Curve, type FigureSpec } from './spec';

export interface Plot {
  chart: uPlot;
  aligned: Aligned;
  xScale: Scale;
  yScale: Scale;
  /** Least and largest x of the data, SI. */
  reach: [number, number];
}

export interface PlotOptions {
  width: number;
  height: number;
  theme: Theme;
  units: UnitSystem;
  hidden: Set<number>;
  /** Range of x that is looked at, SI; null: all of it. */
  zoom: [number, number] | null;
  onCursor: (x: number | null) => void;
  onZoom: (range: [number, number]) => void;
}

const FONT = '12px system-ui, sans-serif';

/** Scales in which a specification is shown. */
export function scalesOf(spec: FigureSpec, units: UnitSystem): { xScale: Scale; yScale: Scale } {
  let size = 0;
  for (const curve of spec.curves) {
    const found = extent(curve.y);
    if (found) size = Math.max(size, Math.abs(found[0]), Math.abs(found[1]));
  }
  return { xScale: scaleOf(X_UNIT[spec.along], units, 1), yScale: scaleOf(spec.yUnit, units, size) };
}

export function axisLabel(label: string, scale: Scale): string {
  return scale.symbol ? `${label}, ${scale.symbol}` : label;
}

function seriesOf(curve: Curve, index: number, options: PlotOptions): uPlot.Series {
  const colour = palette(options.theme).curve[curve.role];
  const series: uPlot.Series = {
    label: curve.label,
    show: !options.hidden.has(index),
    stroke: colour,
    width: curve.points ? 0 : WIDTH[curve.role],
    dash: DASH[curve.role],
    points: curve.points
      ? { show: true, size: 6, space: 0, fill: palette(options.theme).paper, stroke: colour, width: 1.5 }
      : { show: false },
  };
  if (curve.points) series.paths = () => null;
  return series;
}

function axes(spec: FigureSpec, options: PlotOptions, xScale: Scale, yScale: Scale): uPlot.Axis[] {
  const colours = palette(options.theme);
  const common: uPlot.Axis = {
    stroke: colours.muted,
    font: FONT,
    labelFont: FONT,
    labelSize: 20,
    grid: { stroke: colours.grid, width: 1 },
    ticks: { stroke: colours.grid, width: 1, size: 4 },
    values: (_chart, splits) => tickLabels(splits),
  };
  const wide = Math.max(3, Math.floor(options.width / 110));
  return [
    { ...common, label: axisLabel(spec.xLabel, xScale), size: 30, splits: (_c, _i, from, to) => ticks(from, to, wide) },
    {
      ...common,
      label: axisLabel(spec.yLabel, yScale),
      size: (_chart, values: string[] | null) => 16 + 7 * Math.max(2, ...(values ?? []).map((text) => text.length)),
      splits: (_c, _i, from, to) => ticks(from, to, Math.max(3, options.height / 55)),
    },
  ];
}

/** Draws the specification into the root. */
export function makePlot(root: HTMLElement, spec: FigureSpec, options: PlotOptions): Plot {
  const aligned = align(spec.curves);
  const { xScale, yScale } = scalesOf(spec, options.units);
  const reach = extent(aligned.x) ?? [0, 1];
  if (reach[0] === reach[1]) reach[1] = reach[0] + 1;
  const fx = xScale.factor;
  const fy = yScale.factor;
  const shown = (values: (number | null | undefined)[]): (number | null | undefined)[] =>
    values.map((value) => (value === null || value === undefined ? value : value * fy));
  const data = [aligned.x.map((x) => x * fx), ...aligned.y.map(shown)] as uPlot.AlignedData;
  const start = options.zoom ?? reach;
  const colours = palette(options.theme);
  const series: uPlot.Series[] = [{}, ...spec.curves.map((curve, i) => seriesOf(curve, i, options))];
  const yRange = (_chart: uPlot, least: number | null, largest: number | null): uPlot.Range.MinMax => {
    const [low, high] = roomy(spec, (least ?? 0) / fy, (largest ?? fy) / fy);
    return [low * fy, high * fy];
  };
  const chart = new uPlot(
    {
      width: options.width,
      height: options.height,
      padding: [18, 14, 0, 0],
      pxAlign: 0,
      legend: { show: false },
      cursor: {
        y: false,
        drag: { x: true, y: false, dist: 5 },
        points: { size: 7, fill: colours.paper, width: 2 },
      },
      scales: {
        x: {
          time: false,
          range: (_chart, min: number | null, max: number | null) =>
            min === null || max === null ? [0, 1] : [min, max],
        },
        y: { range: yRange },
      },
      axes: axes(spec, options, xScale, yScale),
      series,
      bands: spec.band ? [{ series: [spec.band.high + 1, spec.band.low + 1], fill: colours.band }] : [],
      hooks: {
        setCursor: [
          (u) => {
            const { left, event } = u.cursor;
            if (event) options.onCursor(left === undefined || left < 0 ? null : u.posToVal(left, 'x') / fx);
          },
        ],
        setScale: [
          (u, key) => {
            const { min, max } = u.scales['x'] as uPlot.Scale;
            if (key === 'x' && typeof min === 'number' && typeof max === 'number') options.onZoom([min / fx, max / fx]);
          },
        ],
        drawAxes: [overlay(spec, levelsShown(spec), colours, fx, fy)],
      },
    },
    data,
    root,
  );
  chart.setScale('x', { min: start[0] * fx, max: start[1] * fx });
  return { chart, aligned, xScale, yScale, reach };
}
