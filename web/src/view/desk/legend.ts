// The legend: which colour is which value, and how much larger than true the cable is drawn.
import { el } from '../../dom';
import type { UnitSystem } from '../../state';
import { digits, scaleOf } from '../../units';
import { colourGradient } from '../states/colours';
import type { Quantity } from '../states/quantity';
import { type Scale, ticksOf } from '../states/scale';

export class Legend {
  private readonly title = el('div', { class: 'view-legend-title' });
  private readonly bar = el('div', { class: 'view-legend-bar' });
  private readonly ticks = el('div', { class: 'view-legend-ticks' });
  private readonly beyond = el('div', { class: 'view-legend-note' });
  private readonly factor = el('div', { class: 'view-legend-note' });
  private readonly grid = el('div', { class: 'view-legend-note' });
  readonly root: HTMLElement;

  constructor() {
    this.bar.style.background = colourGradient('to right');
    const scale = el('div', { class: 'view-legend-scale' }, this.bar, this.ticks);
    this.root = el('div', { class: 'view-legend' }, this.title, scale, this.beyond, this.factor, this.grid);
  }

  scale(quantity: Quantity, scale: Scale | null, system: UnitSystem): void {
    this.bar.hidden = this.ticks.hidden = !scale;
    this.beyond.textContent = '';
    if (!scale) {
      this.title.textContent = `${quantity.title}: not in these data`;
      return;
    }
    const { symbol, factor } = scaleOf(quantity.unit, system, scale.high);
    this.title.textContent = `${quantity.title}, ${symbol}`;
    const low = scale.low * factor;
    const high = scale.high * factor;
    this.ticks.replaceChildren(
      ...ticksOf(low, high, 4).map((value) => {
        const tick = el('span', {}, digits(value, 3));
        tick.style.left = `${(100 * (value - low)) / (high - low)}%`;
        return tick;
      }),
    );
    if (scale.beyond !== null)
      this.beyond.textContent = `single peaks to ${digits(scale.beyond * factor, 3)} ${symbol} have the last colour`;
  }

  /** Exaggeration, and the distance between the lines of the grid, m. */
  sizes(factor: number, spacing: number, system: UnitSystem): void {
    const times = factor < 10 ? factor.toFixed(factor < 1.05 ? 0 : 1).replace('.0', '') : factor.toFixed(0);
    this.factor.textContent = factor < 1.05 ? 'true diameter' : `diameter \u00d7 ${times}, rollers and ducts with it`;
    const { symbol, factor: per } = scaleOf('m', system, spacing);
    this.grid.textContent = `grid ${digits(spacing * per, 3)} ${symbol}`;
  }
}
