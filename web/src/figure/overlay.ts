// What a figure shows beside its curves: limits as lines across, events as lines down with their numbers, the steady window shaded.
import type uPlot from 'uplot';
import type { Palette } from './palette';
import type { FigureSpec, Level } from './spec';

type Hook = (chart: uPlot) => void;

export function overlay(spec: FigureSpec, levels: Level[], colours: Palette, fx: number, fy: number): Hook {
  return (chart) => {
    const { ctx, bbox } = chart;
    const ratio = devicePixelRatio;
    const x = (value: number): number => chart.valToPos(value * fx, 'x', true);
    const inside = (at: number): boolean => at >= bbox.left - 1 && at <= bbox.left + bbox.width + 1;
    ctx.save();
    if (spec.window) {
      const from = Math.max(bbox.left, x(spec.window.from));
      const to = Math.min(bbox.left + bbox.width, x(spec.window.to));
      ctx.fillStyle = colours.window;
      if (to > from) ctx.fillRect(from, bbox.top, to - from, bbox.height);
    }
    ctx.lineWidth = 2 * ratio;
    ctx.strokeStyle = colours.limit;
    for (const { value } of levels) {
      const y = chart.valToPos(value * fy, 'y', true);
      if (y < bbox.top || y > bbox.top + bbox.height) continue;
      ctx.beginPath();
      ctx.moveTo(bbox.left, y);
      ctx.lineTo(bbox.left + bbox.width, y);
      ctx.stroke();
    }
    ctx.lineWidth = ratio;
    ctx.strokeStyle = colours.event;
    ctx.fillStyle = colours.event;
    ctx.setLineDash([2 * ratio, 3 * ratio]);
    ctx.font = `600 ${11 * ratio}px system-ui, sans-serif`;
    ctx.textAlign = 'center';
    ctx.textBaseline = 'bottom';
    (spec.events ?? []).forEach((event, i) => {
      const at = x(event.x);
      if (!inside(at)) return;
      ctx.beginPath();
      ctx.moveTo(at, bbox.top);
      ctx.lineTo(at, bbox.top + bbox.height);
      ctx.stroke();
      ctx.fillText(String(i + 1), at, bbox.top - 2 * ratio);
    });
    ctx.restore();
  };
}
