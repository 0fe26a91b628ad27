// The lists at the side and the sentence below. Names are untrusted: they are only ever set as text.
import type { PageData } from './data';
import type { State } from './state';
import { countText, numberText, pairFacts, pairNumber, sortedPairs, type Order } from './words';

const most = 500; // rows at a time

export function element<T extends HTMLElement = HTMLElement>(id: string): T {
  const found = document.getElementById(id);
  if (!found) throw new Error(`the page lacks ${id}`);
  return found as T;
}

export function make<K extends keyof HTMLElementTagNameMap>(tag: K, text = '', className = ''): HTMLElementTagNameMap[K] {
  const made = document.createElement(tag);
  if (text) made.textContent = text;
  if (className) made.className = className;
  return made;
}

export interface Actions {
  choosePair(pair: number | undefined): void;
  focusObject(object: number): void;
  toggle(object: number, what: 'hidden' | 'ghosts' | 'only'): void;
  colourOf(object: number): number;
}

/// Rows, the first `most` of them and a button for more.
function fillList(list: HTMLElement, numbers: number[], row: (number: number) => HTMLElement, none: string): void {
  list.replaceChildren();
  if (numbers.length === 0) list.append(make('li', none, 'none'));
  const addFrom = (first: number) => {
    for (const number of numbers.slice(first, first + most)) list.append(row(number));
    const left = numbers.length - first - most;
    if (left <= 0) return;
    const more = make('button', `${left.toLocaleString('en-US')} more …`, 'more');
    const item = make('li');
    item.append(more);
    more.onclick = () => {
      item.remove();
      addFrom(first + most);
    };
    list.append(item);
  };
  addFrom(0);
}

export class Panels {
  private order: number[] = [];

  constructor(
    private readonly data: PageData,
    private readonly state: State,
    private readonly actions: Actions,
  ) {
    for (const tab of ['contacts', 'objects']) element(`tab-${tab}`).onclick = () => this.open(tab);
    element<HTMLSelectElement>('order').onchange = (event) => {
      state.order = (event.target as HTMLSelectElement).value;
      this.listPairs();
    };
    element('filter').oninput = () => this.listObjects();
    element('title').textContent = data.header.title;
    element('title').title = data.header.title;
    document.title = `${data.header.title} – Toccata`;
    this.summarise();
    this.listPairs();
    this.listObjects();
    this.open(data.report.pairs.length > 0 ? 'contacts' : 'objects');
  }

  open(tab: string): void {
    for (const name of ['contacts', 'objects']) {
      element(name).hidden = name !== tab;
      element(`tab-${name}`).setAttribute('aria-selected', String(name === tab));
    }
  }

  private summarise(): void {
    const { report } = this.data;
    const near = report.pairs.filter((pair) => pair.relation === 'apart').length;
    const triangles = report.objects.reduce((sum, object) => sum + object.triangles, 0);
    const parts = [countText(report.objects.length, 'object')];
    if (triangles > 0) parts.push(countText(triangles, 'triangle'));
    parts.push(`${countText(report.pairs.length - near, 'pair')} in contact`);
    if (near > 0) parts.push(`${countText(near, 'pair')} near`);
    if (report.unit !== 'unit') parts.push(`in ${report.unit}`);
    element('summary').textContent = parts.join(' · ');
    element('summary').title = report.warnings.join('\n');
    element('tab-contacts').textContent = `Contacts ${report.pairs.length.toLocaleString('en-US')}`;
    element('tab-objects').textContent = `Objects ${report.objects.length.toLocaleString('en-US')}`;
  }

  /// The pair `step` places further in the list.
  neighbour(step: number): number | undefined {
    if (this.order.length === 0) return undefined;
    const at = this.state.pair === undefined ? -1 : this.order.indexOf(this.state.pair);
    const next = at < 0 ? (step > 0 ? 0 : this.order.length - 1) : (at + step + this.order.length) % this.order.length;
    return this.order[next];
  }

  listPairs(): void {
    const { header, report } = this.data;
    element<HTMLSelectElement>('order').value = this.state.order;
    this.order = sortedPairs(header, report, this.state.order as Order);
    fillList(element('pair-list'), this.order, (pair) => this.pairRow(pair), 'Nothing collides.');
    this.markPair();
  }

  private pairRow(index: number): HTMLElement {
    const { header, report } = this.data;
    const pair = report.pairs[index];
    const item = make('li');
    item.dataset.pair = String(index);
    const row = make('button', '', 'row');
    row.append(make('span', `${pair.a} – ${pair.b}`));
    const number = pairNumber(header, report, index);
    row.append(make('span', number ? `${relationWord(pair.relation, header.words[index].verb)} · ${number}` : header.words[index].verb, 'what'));
    row.title = `${pair.a} ${header.words[index].verb} ${pair.b}`;
    row.onclick = () => this.actions.choosePair(index);
    item.append(row);
    return item;
  }

  markPair(): void {
    const chosen = this.state.pair;
    for (const item of element('pair-list').children) {
      const is = (item as HTMLElement).dataset.pair === String(chosen);
      item.classList.toggle('chosen', is);
      item.querySelector('.row')?.setAttribute('aria-current', String(is));
      if (is) item.scrollIntoView({ block: 'nearest' });
    }
    this.tellPair();
  }

  private tellPair(): void {
    const { header, report } = this.data;
    const index = this.state.pair;
    element('found').hidden = index === undefined;
    if (index === undefined) return;
    const pair = report.pairs[index];
    const words = header.words[index];
    const sentence = element('sentence');
    sentence.replaceChildren(make('span', pair.a, 'a'), ` ${words.verb} `, make('span', pair.b, 'b'), ` ${words.remark}.`);
    const facts = pairFacts(header, report, index).map((fact) => make('li', fact));
    element('facts').replaceChildren(...facts);
  }

  listObjects(): void {
    const wanted = element<HTMLInputElement>('filter').value.toLowerCase();
    const objects = this.data.report.objects;
    const numbers = objects.map((_, i) => i).filter((i) => objects[i].name.toLowerCase().includes(wanted));
    fillList(element('object-list'), numbers, (object) => this.objectRow(object), objects.length === 0 ? 'There is no object.' : 'No object is named so.');
  }

  private objectRow(index: number): HTMLElement {
    const object = this.data.report.objects[index];
    const { state, actions } = this;
    const item = make('li', '', state.hidden.has(index) || (state.only !== undefined && state.only !== index) ? 'dim' : '');
    const swatch = make('span', '', 'swatch');
    swatch.style.background = `#${actions.colourOf(index).toString(16).padStart(6, '0')}`;
    const row = make('button', '', 'row');
    row.append(make('span', object.name), make('span', describe(object), 'what'));
    row.title = `${object.name}\n${object.source}\npose ${object.pose.map(numberText).join(' ')}`;
    row.onclick = () => actions.focusObject(index);
    const button = (text: string, what: 'hidden' | 'ghosts' | 'only', on: boolean, tells: string) => {
      const made = make('button', text, 'small');
      made.setAttribute('aria-pressed', String(on));
      made.setAttribute('aria-label', `${tells}: ${object.name}`);
      made.title = tells;
      made.onclick = () => actions.toggle(index, what);
      return made;
    };
    item.append(swatch, row);
    item.append(
      button('hide', 'hidden', state.hidden.has(index), 'Hide'),
      button('ghost', 'ghosts', state.ghosts.has(index), 'Show as a ghost'),
      button('only', 'only', state.only === index, 'Show it alone'),
    );
    return item;
  }
}

function relationWord(relation: string, verb: string): string {
  return relation === 'apart' ? 'near' : verb;
}

function describe(object: { shape: string; triangles: number; solid: boolean }): string {
  const size = object.triangles > 0 ? `, ${countText(object.triangles, 'triangle')}` : '';
  return `${object.shape}${size}, ${object.solid ? 'solid' : 'surface'}`;
}
