// The box that switches layers on and off, and slides through the steps of those that have some.
import type { Layer, PageData } from './data';
import { stepColours, themes } from './colours';
import { element, make } from './panels';
import type { State } from './state';

/// What the roles of a pair's layers are called.
const roleNames: Record<string, string> = {
  contact: 'Where they meet',
  depth: 'Depth',
  distance: 'Distance',
  normal: 'Normals',
};

export class LayerPanel {
  constructor(
    private readonly data: PageData,
    private readonly state: State,
    private readonly changed: () => void,
  ) {}

  show(): void {
    const panel = element('layers');
    if (panel.contains(document.activeElement) && panel.dataset.pair === String(this.state.pair)) return;
    panel.dataset.pair = String(this.state.pair);
    const { layers } = this.data.header;
    const shown = layers.filter((layer) => layer.pair !== undefined && (this.state.pair === undefined ? layer.role === 'contact' : layer.pair === this.state.pair));
    const roles = [...new Set(shown.map((layer) => layer.role))];
    panel.replaceChildren(...roles.map((role) => this.roleSwitch(role)));
    layers.forEach((layer, i) => {
      const { pair } = this.state;
      const ofPair = pair === undefined || layer.object === undefined || this.isOf(layer.object, pair);
      if (layer.steps && layer.steps.length > 0 && ofPair) panel.append(this.stepSlider(layer, layer.steps.length, i));
    });
  }

  private isOf(object: number, pair: number): boolean {
    const { a_index, b_index } = this.data.report.pairs[pair];
    return object === a_index || object === b_index;
  }

  private roleSwitch(role: string): HTMLElement {
    const label = make('label');
    const box = make('input');
    box.type = 'checkbox';
    box.checked = !this.state.off.has(role);
    box.onchange = () => {
      if (box.checked) this.state.off.delete(role);
      else this.state.off.add(role);
      this.changed();
    };
    const colour = (themes[this.state.theme] as unknown as Record<string, number>)[role] ?? stepColours[0];
    const key = make('i');
    key.style.background = `#${colour.toString(16).padStart(6, '0')}`;
    label.append(box, key, roleNames[role] ?? role);
    return label;
  }

  private stepSlider(layer: Layer, count: number, index: number): HTMLElement {
    const whole = make('div');
    const name = make('label', layer.name ?? layer.role);
    const slider = make('input');
    slider.type = 'range';
    slider.min = '-1';
    slider.max = String(count - 1);
    slider.value = String(this.state.steps.get(index) ?? -1);
    slider.setAttribute('aria-label', layer.name ?? layer.role);
    const tell = make('output');
    const say = () => {
      const step = layer.steps?.[Number(slider.value)];
      tell.textContent = step ? `${step.label}${step.note ? `: ${step.note}` : ''}` : 'not shown';
    };
    slider.oninput = () => {
      const step = Number(slider.value);
      if (step < 0) this.state.steps.delete(index);
      else this.state.steps.set(index, step);
      say();
      this.changed();
    };
    say();
    whole.append(name, slider, tell);
    return whole;
  }
}
