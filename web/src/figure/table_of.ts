// The figures of a figure as a table: a column a curve, a row a place or time.
import type { UnitSystem } from '../state';
import { align } from './align';
import { scalesOf } from './plot';
import type { FigureSpec } from './spec';
import type { DataTable } from './table';

export function tableOf(spec: FigureSpec, units: UnitSystem): DataTable {
  const { xScale, yScale } = scalesOf(spec, units);
  const aligned = align(spec.curves);
  const columns = [
    { label: spec.xLabel, unit: xScale.symbol },
    ...spec.curves.map((curve) => ({ label: curve.label, unit: yScale.symbol })),
  ];
  const rows = aligned.x.map((x, i) => [
    x * xScale.factor,
    ...aligned.y.map((values) => {
      const value = values[i];
      return typeof value === 'number' ? value * yScale.factor : value;
    }),
  ]);
  return { name: `hawser-${spec.id}`, columns, rows };
}
