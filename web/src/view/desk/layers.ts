// The environment's panel: how solid it is, whether it is cut away toward the camera, which layers are shown, how exact it is.
import type { Surroundings } from '../../data';
import { el } from '../../dom';
import type { UnitSystem } from '../../state';
import { grouped, show } from '../../units';
import type { Environment } from '../scene/environment';

const SHARE = 100;

export class LayersPanel {
  readonly root: HTMLDetailsElement;
  private readonly exact = el('p', { class: 'view-legend-note' });

  /** `changed`: the picture has to be drawn again. */
  constructor(
    private readonly of: Surroundings,
    drawn: Environment,
    changed: () => void,
  ) {
    const solid = el('input', { type: 'range', min: 0, max: SHARE, step: 5, value: SHARE, class: 'view-thick' });
    solid.setAttribute('aria-label', 'How solid the environment is drawn');
    solid.addEventListener('input', () => {
      drawn.fade(solid.valueAsNumber / SHARE);
      changed();
    });
    const tick = (text: string, on: (checked: boolean) => void): [HTMLElement, HTMLInputElement] => {
      const box = el('input', { type: 'checkbox', checked: true });
      box.addEventListener('change', () => {
        on(box.checked);
        changed();
      });
      return [el('label', { class: 'view-field' }, box, text), box];
    };
    const [cut] = tick('cut away toward the camera', (checked) => drawn.cut(checked));
    const layers = of.layers.map((name, i) =>
      tick(name || 'without a name', (checked) => {
        drawn.shown[i] = checked;
        drawn.choose();
      }),
    );
    const [all] = tick('all layers', (checked) => {
      layers.forEach(([, box]) => (box.checked = checked));
      drawn.shown.fill(checked);
      drawn.choose();
    });
    this.root = el(
      'details',
      { class: 'view-layers' },
      el('summary', {}, 'Environment'),
      el('label', { class: 'view-field' }, 'faded', solid, 'solid'),
      cut,
      el(
        'div',
        { class: 'view-layer-list', role: 'group', 'aria-label': 'Layers of the environment' },
        all,
        ...layers.map(([label]) => label),
      ),
      this.exact,
    );
  }

  /** What is drawn of the models, and how far that is from them, in those units. */
  units(system: UnitSystem): void {
    const { given, n_triangles: shown, error_m: error, step_m: step } = this.of;
    const length = (metres: number): string => show(metres, 'mm', system, 2);
    const number = (n: number): string => grouped(String(n));
    this.exact.textContent =
      shown < given
        ? `${number(shown)} triangles of ${number(given)}, at most ${length((error ?? 0) + step)} from them`
        : `all ${number(given)} triangles, corners rounded to ${length(step)}`;
  }
}
