// Playback in three dimensions.
import './view.css';
import type { RunData } from '../data';
import { el } from '../dom';
import type { Store } from '../state';
import { CameraDesk } from './desk/camera_desk';
import { unpackFrames } from './states/frames';
import { HELP, listenToKeys } from './desk/keys';
import { rollerForces } from './desk/picked';
import { paperPicture } from './paper';
import { LayersPanel } from './desk/layers';
import { listenToPointer } from './desk/pointer';
import { Narrator } from './desk/sentence';
import { Viewer } from './viewer';
import { World } from './scene/world';

export interface View {
  /** Resolves when all states are unpacked. */
  readonly ready: Promise<void>;
  /** A still picture for paper; null where there is none. */
  onPaper(): HTMLElement | null;
  /** For tests and measurements. */
  readonly viewer: Viewer;
  /** Frees what the view holds and empties its root. */
  dispose(): void;
}

const NO_WEBGL =
  'This browser does not draw in three dimensions here (no WebGL). Times and figures below still work, and everything is in the figures of this page.';
const NO_STATES = 'These results hold no states (results.h5), so nothing moves.';

function help(): HTMLElement {
  const keys = HELP.flatMap(([key, what]) => [el('span', {}, el('kbd', {}, key), ` ${what}`), ' ']);
  const mouse =
    'Drag turns, the right button moves, the wheel zooms once the picture has been clicked. A click on a roller or the cable shows its figures over time, a double click goes there.';
  return el(
    'details',
    { class: 'view-help' },
    el(
      'summary',
      {},
      'Space plays, \u2190 \u2192 step, + \u2212 zoom, 1\u20139 move the camera, F follows the head; all keys and the mouse',
    ),
    el('p', {}, mouse),
    el('p', {}, ...keys),
  );
}

/** The scene; null and a notice where the browser has no WebGL. */
function worldIn(stage: HTMLElement, viewer: Viewer): World | null {
  const still = window.matchMedia('(prefers-reduced-motion: reduce)').matches;
  try {
    return new World(stage, viewer.model, still, viewer.beside);
  } catch (error) {
    console.info(error);
    stage.classList.add('view-stage-empty');
    stage.prepend(el('p', { class: 'view-notice', role: 'note' }, NO_WEBGL));
    return null;
  }
}

/** The mouse on the picture: places and rollers under it go to the store, a click picks. */
function usePointer(world: World, viewer: Viewer, store: Store): () => void {
  const canvas = world.stage.renderer.domElement;
  let hovered = -1;
  const hoverRoller = (roller: number): void => {
    if (roller === hovered) return;
    hovered = roller;
    const picked = store.get('roller') ?? -1;
    world.rollers?.mark(picked, roller);
    viewer.hover(roller);
  };
  return listenToPointer(canvas, {
    hover: (x, y) => {
      const roller = world.rollerAt(x, y);
      hoverRoller(roller);
      const place = roller >= 0 ? (viewer.model.run.geometry?.rollers[roller]?.s_m ?? null) : world.placeAt(x, y);
      canvas.style.cursor = roller >= 0 || place !== null ? 'pointer' : '';
      store.set('place', place);
    },
    leave: () => {
      hoverRoller(-1);
      store.set('place', null);
    },
    click: (x, y) => {
      canvas.focus({ preventScroll: true });
      const roller = world.rollerAt(x, y);
      const place = world.placeAt(x, y);
      viewer.inspect(roller >= 0 ? { roller } : place !== null ? { place } : null);
    },
    double: (x, y) => {
      viewer.toPlace(world.placeAt(x, y));
    },
  });
}

/** `together`: the runs of the chains that are pulled together with this one. */
export function mountView(root: HTMLElement, run: RunData, store: Store, together: readonly RunData[] = []): View {
  const words = el('p');
  const spoken = el('p', { class: 'view-spoken', 'aria-live': 'polite' });
  const viewer = new Viewer(run, store, new Narrator(words, spoken), together);
  const stage = el('div', { class: 'view-stage' });
  const shell = el(
    'div',
    { class: 'view3d', role: 'group', 'aria-label': 'The pull in three dimensions' },
    viewer.tools.root,
    stage,
    viewer.player.root,
    el('div', { class: 'view-words' }, words, spoken, help()),
  );
  root.replaceChildren(shell);
  const ends: (() => void)[] = [];
  let panel: LayersPanel | null = null;
  const world = worldIn(stage, viewer);
  if (world) {
    viewer.draws(
      world,
      new CameraDesk(
        world,
        () => viewer.now,
        () => viewer.playback.time,
      ),
    );
    stage.append(viewer.legend.root, viewer.inspector.root);
    const { environment } = world;
    if (environment) {
      const made = new LayersPanel(environment.of, environment, () => world.stage.invalidate());
      panel = made;
      viewer.tools.root.append(made.root);
    }
    const canvas = world.stage.renderer.domElement;
    canvas.tabIndex = 0;
    canvas.setAttribute('role', 'img');
    canvas.setAttribute('aria-label', 'Route, rollers and cable; keys and a sentence on what is to be seen are below');
    // The wheel scrolls the page until the reader has turned to the picture.
    world.stage.controls.enableZoom = false;
    canvas.addEventListener('focus', () => (world.stage.controls.enableZoom = true));
    canvas.addEventListener('blur', () => (world.stage.controls.enableZoom = false));
    ends.push(usePointer(world, viewer, store));
  }
  const dress = (): void => {
    shell.dataset['theme'] = store.get('theme');
    viewer.redress();
    panel?.units(store.get('units'));
  };
  ends.push(
    listenToKeys(shell, viewer),
    store.subscribe('units', dress),
    store.subscribe('theme', dress),
    store.subscribe('place', () => viewer.mark()),
    store.subscribe('time', (time, source) => {
      if (source !== viewer && time !== null) viewer.showAt(time);
    }),
    store.subscribe('roller', (roller, source) => {
      if (source !== viewer) viewer.inspect(roller === null ? null : { roller });
    }),
  );
  dress();
  viewer.preset(0, true);
  const ready = unpack(run, viewer, words);
  return {
    ready,
    viewer,
    onPaper: () => paperPicture(viewer, store),
    dispose: () => {
      ends.forEach((end) => end());
      viewer.dispose();
      root.replaceChildren();
    },
  };
}

/** Unpacks the environment; what is damaged, or too large for the build that wrote it, is said. */
async function surround(viewer: Viewer, words: HTMLElement): Promise<void> {
  const { world, model } = viewer;
  try {
    await world?.environment?.unpack();
    world?.stage.invalidate();
  } catch (error) {
    words.after(
      el('p', {}, `The environment cannot be shown: ${error instanceof Error ? error.message : String(error)}.`),
    );
  }
  const around = model.run.environment;
  if (around && around.n_triangles === 0)
    words.after(
      el('p', {}, `The environment is not shown: its ${around.given} triangles are more than this build can simplify.`),
    );
}

/** Unpacks the states while the page goes on; what is damaged is said. */
async function unpack(run: RunData, viewer: Viewer, words: HTMLElement): Promise<void> {
  await surround(viewer, words);
  if (!run.states || run.states.frames === 0) {
    words.textContent = NO_STATES;
    return;
  }
  words.textContent = 'Unpacking the states\u2026';
  try {
    await unpackFrames(run.states, (frames, name) => viewer.arrived(frames, name));
    for (const [k, { states }] of viewer.beside.runs.entries()) {
      if (states && states.frames > 0) await unpackFrames(states, (frames) => viewer.besideArrived(k, frames));
    }
    viewer.forces = await rollerForces(run);
    viewer.inspectAgain();
  } catch (error) {
    words.textContent = `The states cannot be shown: ${error instanceof Error ? error.message : String(error)}.`;
  }
}
