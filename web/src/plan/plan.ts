// The route from above, both directions to the same scale, with what stands on it.
import type { Context } from '../context';
import { button, el, svg } from '../dom';
import { valueAt } from '../figure/align';
import { tableTools } from '../figure/table';
import { digits, scaleOf, show } from '../units';
import { equipment, markPath, placeNear, planeOf, planLegend } from './marks';
import { standsTable } from './stands';
import { bounds, scaled, shaped, Zoom } from './zoom';

const WIDE = 900;
const KEYS = 'Arrow keys move it, plus and minus zoom, 0 shows all.';

/** The drawing with its zoom, linked to the place along the route; null without geometry. */
export function planDrawing(context: Context): HTMLElement | null {
  const { run, store, units } = context;
  const geometry = run.geometry;
  if (!geometry || geometry.route.position_m.length < 2) return null;
  const plane = planeOf(geometry);
  const ends = [geometry.reel?.center_m, geometry.winch?.position_m].filter((point) => point !== undefined);
  const rollers = geometry.rollers.map((roller) => roller.position_m);
  const tight = bounds([...geometry.route.position_m, ...rollers, ...ends].map(plane));
  const ratio = Math.min(6, Math.max(1.8, tight.width / Math.max(tight.height, 1e-9)));
  const all = scaled(shaped({ ...tight, width: Math.max(tight.width, 1e-3) }, ratio), 1.1);
  const pointer = svg('path', { class: 'plan-pointer', 'vector-effect': 'non-scaling-stroke', d: '' });
  const label = `Plan of the route, ${show(geometry.route.s_m.at(-1), 'm', units)} long`;
  const drawing = svg(
    'svg',
    { class: 'plan', width: WIDE, height: WIDE / ratio, role: 'img', 'aria-label': label },
    ...equipment(geometry, plane),
    pointer,
  );
  const frame = el('div', { class: 'frame', tabindex: 0, role: 'group', 'aria-label': `${label}. ${KEYS}` }, drawing);
  const width = el('p', { class: 'plan-scale' });
  const scale = scaleOf('m', units, 1);
  const self = {};
  const zoom = new Zoom(
    drawing,
    frame,
    all,
    (view) => (width.textContent = `Width of the drawing: ${digits(view.width * scale.factor, 3)} ${scale.symbol}.`),
    (point) => {
      const place = point && placeNear(geometry, plane, point[0], point[1]);
      store.set('place', place, self);
      follow(place);
    },
  );
  const follow = (place: number | null): void => {
    const { s_m: s, position_m: position } = geometry.route;
    const [x, y, z] = ([0, 1, 2] as const).map((axis) =>
      place === null
        ? null
        : valueAt(
            s,
            position.map((point) => point[axis]),
            place,
          ),
    );
    const known = typeof x === 'number' && typeof y === 'number' && typeof z === 'number';
    pointer.setAttribute('d', known ? markPath(plane([x, y, z])) : '');
  };
  context.onDispose(store.subscribe('place', (place, source) => source !== self && follow(place)));
  follow(store.get('place'));
  const tools = el(
    'div',
    { class: 'tools' },
    button('Zoom in', () => zoom.zoomIn()),
    button('Show all', () => zoom.showAll()),
  );
  const [csv, place] = tableTools(
    () => standsTable(geometry, units),
    'What stands where',
    false,
    () => {},
  );
  if (csv) tools.append(...csv.childNodes);
  const behind = place ? [place] : [];
  return el(
    'figure',
    { id: 'figure-plan', class: 'figure' },
    el('h3', {}, 'Plan'),
    planLegend(geometry),
    frame,
    el(
      'figcaption',
      {},
      el('p', { class: 'caption' }, 'The route from above, both directions to the same scale.'),
      width,
      tools,
      ...behind,
    ),
  );
}
