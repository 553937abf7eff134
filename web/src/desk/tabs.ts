/** Tabs of which one is shown, by click and by arrow keys. */
export class Tabs<T extends string> {
  shown: T;

  /** panels: by the tab's name, which `tab-NAME` is the button of. */
  constructor(
    private readonly panels: Record<T, HTMLElement>,
    first: NoInfer<T>,
    private readonly onShow: (name: T) => void,
  ) {
    this.shown = first;
    const names = Object.keys(panels) as T[];
    for (const name of names) {
      this.button(name).addEventListener('click', () => this.show(name));
      this.button(name).addEventListener('keydown', (event) => {
        const step = { ArrowRight: 1, ArrowLeft: names.length - 1 }[event.key];
        const next = step && names[(names.indexOf(this.shown) + step) % names.length];
        if (!next) return;
        this.show(next);
        this.button(next).focus();
      });
    }
    this.mark();
  }

  private button(name: T): HTMLElement {
    return document.getElementById(`tab-${name}`) as HTMLElement;
  }

  private mark(): void {
    for (const name of Object.keys(this.panels) as T[]) {
      this.panels[name].hidden = name !== this.shown;
      this.button(name).setAttribute('aria-selected', String(name === this.shown));
      this.button(name).tabIndex = name === this.shown ? 0 : -1;
    }
  }

  show(name: T): void {
    this.shown = name;
    this.mark();
    this.onShow(name);
  }
}
