// The view on paper: all of the route at the moment of the largest tension, as one picture with its labels and the legend.
import { el, svg } from '../dom';
import type { Store } from '../state';
import type { Labels } from './scene/labels';
import { sentence } from './desk/sentence';
import type { Viewer } from './viewer';

/** Pixels a CSS pixel. */
const DENSITY = 2;
const LETTERS = {
  'font-size': 12,
  'text-anchor': 'middle',
  'paint-order': 'stroke',
  stroke: '#fff',
  'stroke-width': 4,
};

function labelled(url: string, labels: Labels, width: number, height: number): SVGSVGElement {
  const words = labels
    .shown()
    .flatMap(({ text, x, y, aside }) => [
      svg('circle', { cx: x, cy: y, r: 2, fill: '#000' }),
      svg('text', { x: x + aside, y: y - 10, ...LETTERS }, text),
    ]);
  const picture = svg('image', { href: url, width, height });
  return svg('svg', { viewBox: `0 0 ${width} ${height}`, class: 'view-still', role: 'img' }, picture, ...words);
}

/** Shows that moment in the colours of paper, takes the picture, and puts everything back; null without states or WebGL. */
export function paperPicture(viewer: Viewer, store: Store): HTMLElement | null {
  const { world, now, playback, model } = viewer;
  const time = now?.frames.timeOfLargest('tension') ?? null;
  if (!world || !now || time === null) return null;
  const { stage } = world;
  const was = { time: playback.time, pose: stage.goal };
  world.paint('light');
  viewer.preset(0, true);
  viewer.showAt(time);
  const url = stage.shot(DENSITY);
  const drawing = labelled(url, world.labels, stage.width, stage.height);
  const words = sentence(now, model, store.get('units'));
  const legend = viewer.legend.root.cloneNode(true) as HTMLElement;
  world.paint(store.get('theme'));
  viewer.showAt(was.time);
  stage.go(was.pose, true);
  return el('div', { class: 'view-paper view3d' }, drawing, legend, el('p', { class: 'caption' }, words));
}
