// The route from above, both directions to the same scale, with what stands on it.
import type { Context } from '../context';
import type { Geometry, Point } from '../data';
import { button, el, svg } from '../dom';
import { valueAt } from '../figure/align';
import { digits, scaleOf } from '../units';
import { byKey, scaled, shaped, type Box } from './zoom';

const WIDE = 900;

type Plane = (point: Point) => [number, number];

/** East to the right and north up, turned by a quarter where the route is higher than wide. */
function planeOf(geometry: Geometry): Plane {
  const route = geometry.route.position_m;
  const span = (axis: 0 | 1): number => {
    const values = route.map((point) => point[axis]);
    return Math.max(...values) - Math.min(...values);
  };
  return span(1) > 1.2 * span(0) ? (point) => [point[1], point[0]] : (point) => [point[0], -point[1]];
}

function bounds(points: [number, number][]): Box {
  const xs = points.map((point) => point[0]);
  const ys = points.map((point) => point[1]);
  const [x, y] = [Math.min(...xs), Math.min(...ys)];
  return { x, y, width: Math.max(...xs) - x, height: Math.max(...ys) - y };
}

function line(points: Point[], plane: Plane, attributes: Record<string, string | number>): SVGElement {
  const d = points
    .map((point) =>
      plane(point)
        .map((value) => value.toFixed(3))
        .join(' '),
    )
    .join('L');
  return svg('path', { d: `M${d}`, fill: 'none', 'vector-effect': 'non-scaling-stroke', ...attributes });
}

/** A mark of a size on the screen that does not grow with the zoom. */
function dot(at: [number, number], className: string, label: string): SVGElement {
  const [x, y] = at;
  const path = svg('path', { d: `M${x} ${y}h0`, class: className, 'vector-effect': 'non-scaling-stroke' });
  path.append(svg('title', {}, label));
  return path;
}

function equipment(geometry: Geometry, plane: Plane): SVGElement[] {
  const parts: SVGElement[] = [];
  for (const surface of geometry.surfaces) {
    if (surface.points_m.length > 1) parts.push(line(surface.points_m, plane, { class: 'plan-surface' }));
  }
  parts.push(line(geometry.route.position_m, plane, { class: 'plan-route' }));
  for (const conveyor of geometry.conveyors) {
    if (conveyor.points_m.length > 1) parts.push(line(conveyor.points_m, plane, { class: 'plan-conveyor' }));
  }
  for (const roller of geometry.rollers) parts.push(dot(plane(roller.position_m), 'plan-roller', roller.name));
  if (geometry.reel) parts.push(dot(plane(geometry.reel.center_m), 'plan-reel', 'reel'));
  if (geometry.winch) parts.push(dot(plane(geometry.winch.position_m), 'plan-winch', 'winch'));
  return parts;
}

/** The nearest place along the route to a point of the drawing. */
function placeNear(geometry: Geometry, plane: Plane, x: number, y: number): number | null {
  let best: number | null = null;
  let least = Infinity;
  geometry.route.position_m.forEach((point, i) => {
    const [px, py] = plane(point);
    const away = (px - x) ** 2 + (py - y) ** 2;
    if (away < least) {
      least = away;
      best = geometry.route.s_m[i] ?? null;
    }
  });
  return best;
}

function legend(geometry: Geometry): HTMLElement {
  const entries: [string, boolean][] = [
    ['route', true],
    ['roller', geometry.rollers.length > 0],
    ['conveyor', geometry.conveyors.length > 0],
    ['surface', geometry.surfaces.length > 0],
    ['reel', geometry.reel !== null],
    ['winch', geometry.winch !== null],
  ];
  const item = (name: string): HTMLElement => {
    const shape = ['route', 'conveyor', 'surface'].includes(name) ? 'M2 6H24' : 'M13 6h0';
    const mark = svg('path', { d: shape, class: `plan-${name}` });
    const label =
      name === 'surface' ? 'ducts, trays, walls' : name === 'conveyor' || name === 'roller' ? `${name}s` : name;
    return el(
      'li',
      {},
      el(
        'span',
        { class: 'legend-item' },
        svg('svg', { width: 26, height: 12, class: 'swatch', 'aria-hidden': 'true' }, mark),
        label,
      ),
    );
  };
  return el('ul', { class: 'legend' }, ...entries.filter(([, there]) => there).map(([name]) => item(name)));
}

/** The drawing with its zoom and its link to the place; null without geometry. */
export function planDrawing(context: Context): HTMLElement | null {
  const { run, store, units } = context;
  const geometry = run.geometry;
  if (!geometry || geometry.route.position_m.length < 2) return null;
  const plane = planeOf(geometry);
  const tight = bounds(
    [...geometry.route.position_m, ...geometry.rollers.map((roller) => roller.position_m)].map(plane),
  );
  const ratio = Math.min(6, Math.max(1.6, tight.width / Math.max(tight.height, 1e-9)));
  const all = scaled(shaped({ ...tight, width: Math.max(tight.width, 1e-3) }, ratio), 1.08);
  let view = all;

  const pointer = svg('path', { class: 'plan-pointer', 'vector-effect': 'non-scaling-stroke', d: '' });
  const band = svg('rect', { class: 'plan-band', 'vector-effect': 'non-scaling-stroke', width: 0, height: 0 });
  const drawing = svg(
    'svg',
    {
      class: 'plan',
      width: WIDE,
      height: WIDE / ratio,
      role: 'img',
      'aria-label': `Plan of the route, ${digits(geometry.route.s_m.at(-1) ?? 0)} m long`,
    },
    ...equipment(geometry, plane),
    pointer,
    band,
  );
  const bar = el('p', { class: 'plan-scale' });
  const show = (box: Box): void => {
    view = box;
    drawing.setAttribute('viewBox', `${box.x} ${box.y} ${box.width} ${box.height}`);
    const scale = scaleOf('m', units, 1);
    bar.textContent = `Width of the drawing: ${digits(box.width * scale.factor, 3)} ${scale.symbol}.`;
  };
  show(all);

  const at = (event: MouseEvent): [number, number] => {
    const area = drawing.getBoundingClientRect();
    return [
      view.x + ((event.clientX - area.left) / area.width) * view.width,
      view.y + ((event.clientY - area.top) / area.height) * view.height,
    ];
  };
  const self = {};
  const follow = (place: number | null): void => {
    const { s_m: s, position_m: position } = geometry.route;
    const part = (axis: 0 | 1 | 2): number | null =>
      place === null
        ? null
        : valueAt(
            s,
            position.map((point) => point[axis]),
            place,
          );
    const [x, y, z] = [part(0), part(1), part(2)];
    if (x === null || y === null || z === null) pointer.setAttribute('d', '');
    else pointer.setAttribute('d', `M${plane([x, y, z]).join(' ')}h0`);
  };
  context.onDispose(store.subscribe('place', follow));
  follow(store.get('place'));

  let start: [number, number] | null = null;
  const boxTo = (end: [number, number]): Box => bounds([start ?? end, end]);
  drawing.addEventListener('mousedown', (event) => {
    start = at(event);
    event.preventDefault();
  });
  drawing.addEventListener('mousemove', (event) => {
    const here = at(event);
    if (start) for (const [key, value] of Object.entries(boxTo(here))) band.setAttribute(key, String(value));
    const place = placeNear(geometry, plane, here[0], here[1]);
    store.set('place', place, self);
  });
  drawing.addEventListener('mouseup', (event) => {
    const box = boxTo(at(event));
    if (start && Math.max(box.width, box.height) > view.width * 0.02) show(shaped(box, ratio));
    start = null;
    band.setAttribute('width', '0');
  });
  drawing.addEventListener('mouseleave', () => {
    start = null;
    band.setAttribute('width', '0');
    store.set('place', null, self);
  });
  drawing.addEventListener('dblclick', () => show(all));

  const frame = el(
    'div',
    {
      class: 'frame plan-frame',
      tabindex: 0,
      role: 'group',
      'aria-label': 'Plan of the route. Arrow keys move it, plus and minus zoom, 0 shows all.',
    },
    drawing,
  );
  frame.addEventListener('keydown', (event) => {
    const box = event.ctrlKey || event.metaKey || event.altKey ? null : byKey(event.key, view, all);
    if (!box) return;
    event.preventDefault();
    show(box);
  });
  const tools = el(
    'div',
    { class: 'tools' },
    button('Zoom in', () => show(scaled(view, 0.5))),
    button('Show all', () => show(all)),
  );
  return el(
    'figure',
    { id: 'figure-plan', class: 'figure' },
    el('h3', {}, 'Plan'),
    legend(geometry),
    frame,
    el(
      'figcaption',
      {},
      el('p', { class: 'caption' }, 'The route from above, both directions to the same scale.'),
      bar,
      tools,
    ),
  );
}
