// The lists at the side and the sentence below. Names are untrusted: they are only ever set as text.
import { ClashList, groupings, offeredGroupings, type Grouping, type Listed } from './clash_list';
import type { PageData } from './data';
import { LongList } from './long_list';
import { sorted, textOf, type Finding, type Findings, type Order, type Part } from './findings';
import { statuses, type Review, type ReviewStatus } from './review';
import type { State } from './state';
import { isDim, isSetFor, Tree, type Row } from './tree';
import { isolated } from './visible';
import { countText, numberText } from './words';

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
  choose(finding: number | undefined): void;
  focus(objects: number[]): void;
  toggle(objects: number[], what: 'hidden' | 'ghosts' | 'only'): void;
  colourOf(object: number): number;
}

/// A name among words: what it is written in does not turn these round.
const nameIn = (name: string, className = '') => {
  const made = make('bdi', name);
  if (className) made.className = className;
  return made;
};

const orderNames: Record<Order, string> = {
  deepest: 'deepest first',
  largest: 'most faces first',
  nearest: 'nearest first',
  listed: 'as listed',
};

const tabs = ['findings', 'objects'];

export class Panels {
  private order: number[] = [];
  private readonly tree: Tree;
  private readonly list: ClashList;
  private listed: Listed[] = [];
  private readonly findingRows: LongList<Listed>;
  private readonly objectRows: LongList<Row>;
  private readonly hasReview: boolean;

  constructor(
    private readonly data: PageData,
    private readonly findings: Findings,
    private readonly state: State,
    private readonly review: Review,
    private readonly actions: Actions,
  ) {
    this.tree = new Tree(data);
    this.list = new ClashList(data.report, findings.all, review);
    this.findingRows = new LongList(element('finding-list'), { row: (row) => this.listRow(row), isHeading: (row) => row.finding === undefined });
    this.objectRows = new LongList(element('object-list'), { row: (row) => this.objectRow(row), isHeading: () => false });
    this.hasReview = data.report.schema.startsWith('toccata/check/') && findings.all.length > 0;
    this.offerGroupings();
    this.listenToReview();
    for (const tab of tabs) {
      element(`tab-${tab}`).onclick = () => this.open(tab);
      element(`tab-${tab}`).onkeydown = (event) => this.goToTab(event);
    }
    this.offerOrders();
    element('filter').oninput = () => this.listObjects();
    element('title').replaceChildren(nameIn(data.header.title));
    element('title').title = data.header.title;
    document.title = `${isolated(data.header.title)} – Toccata`;
    this.summarise();
    this.listFindings();
    this.listObjects();
    this.open(findings.all.length > 0 ? 'findings' : 'objects');
  }

  private offerGroupings(): void {
    const offered = offeredGroupings(this.data, this.findings.all);
    const select = element<HTMLSelectElement>('grouping');
    for (const grouping of offered) {
      const option = make('option', groupings[grouping]);
      option.value = grouping;
      select.append(option);
    }
    select.value = this.list.grouping;
    select.onchange = () => {
      this.list.grouping = select.value as Grouping;
      this.listFindings();
    };
    element('clash-tools').hidden = offered.length === 0;
    element('review-bar').hidden = !this.hasReview;
    const filter = element<HTMLInputElement>('clash-filter');
    filter.oninput = () => {
      this.list.filter = filter.value;
      this.listFindings();
    };
  }

  /// What is said of the chosen clash.
  private listenToReview(): void {
    const status = element<HTMLSelectElement>('review-status');
    for (const one of statuses) status.append(make('option', one));
    const comment = element<HTMLTextAreaElement>('review-comment');
    const say = () => {
      const names = this.chosenNames();
      if (!names) return;
      this.review.set({ ...names, status: status.value as ReviewStatus, comment: comment.value.trim() });
      element('review-told').textContent = 'not saved yet';
      this.listFindings();
    };
    status.onchange = say;
    comment.onchange = say;
  }

  private chosenNames(): { a: string; b: string } | undefined {
    const finding = this.state.finding === undefined ? undefined : this.findings.all[this.state.finding];
    if (finding?.a === undefined || finding.b === undefined) return undefined;
    const { objects } = this.data.report;
    return { a: objects[finding.a].name, b: objects[finding.b].name };
  }

  private showReview(): void {
    const names = this.chosenNames();
    element('review').hidden = !names || !this.hasReview;
    if (!names) return;
    const remark = this.review.of(names.a, names.b);
    element<HTMLSelectElement>('review-status').value = remark.status;
    const comment = element<HTMLTextAreaElement>('review-comment');
    if (document.activeElement !== comment) comment.value = remark.comment;
  }

  private offerOrders(): void {
    const select = element<HTMLSelectElement>('order');
    for (const order of this.findings.orders) {
      const option = make('option', orderNames[order]);
      option.value = order;
      select.append(option);
    }
    element('sorting').hidden = this.findings.orders.length < 2;
    select.onchange = () => {
      this.state.order = select.value as Order;
      this.listFindings();
    };
  }

  /// Texts, and names of objects among them.
  private filled<T extends HTMLElement>(made: T, parts: Part[], finding: Finding): T {
    const { objects } = this.data.report;
    const classOf = (object: number) => (object === finding.a ? 'a' : object === finding.b ? 'b' : '');
    made.append(...parts.map((part) => (typeof part === 'string' ? part : nameIn(objects[part.object].name, made.id ? classOf(part.object) : ''))));
    return made;
  }

  open(tab: string): void {
    for (const name of tabs) {
      element(name).hidden = name !== tab;
      element(`tab-${name}`).setAttribute('aria-selected', String(name === tab));
      element(`tab-${name}`).tabIndex = name === tab ? 0 : -1;
    }
  }

  /// The arrows go from a tab to the other, and Tab into what is open, as readers of the screen expect of tabs.
  private goToTab(event: KeyboardEvent): void {
    const others: Record<string, string> = { ArrowLeft: 'other', ArrowRight: 'other', Home: tabs[0], End: tabs[1] };
    const wanted = others[event.key];
    if (!wanted) return;
    event.preventDefault();
    event.stopPropagation();  // the arrows turn the scene elsewhere
    const tab = wanted === 'other' ? (element('findings').hidden ? tabs[0] : tabs[1]) : wanted;
    this.open(tab);
    element(`tab-${tab}`).focus();
  }

  private summarise(): void {
    const { report } = this.data;
    const triangles = report.objects.reduce((sum, object) => sum + object.triangles, 0);
    const parts = [countText(report.objects.length, 'object')];
    if (triangles > 0) parts.push(countText(triangles, 'triangle'));
    parts.push(...this.findings.summary);
    if (report.unit !== 'unit') parts.unshift(/^[-+.\d]/.test(report.unit) ? `in units of ${report.unit}` : `in ${report.unit}`);
    element('summary').textContent = parts.join(' · ');
    element('summary').title = [parts.join(' · '), ...report.warnings].join('\n');
    if (report.unfinished) {
      element('partial').textContent = `Stopped: ${countText(report.unfinished, 'pair')} not looked at`;
      element('partial').hidden = false;
    }
    element('tab-findings').textContent = this.findings.name;
    element('tab-objects').textContent = `Objects ${report.objects.length.toLocaleString('en-US')}`;
  }

  /// The finding `step` places further in the list.
  neighbour(step: number): number | undefined {
    if (this.order.length === 0) return undefined;
    const at = this.state.finding === undefined ? -1 : this.order.indexOf(this.state.finding);
    const next = at < 0 ? (step > 0 ? 0 : this.order.length - 1) : (at + step + this.order.length) % this.order.length;
    return this.order[next];
  }

  listFindings(): void {
    const { orders, all, none } = this.findings;
    const order = this.state.order && orders.includes(this.state.order) ? this.state.order : orders[0];
    element<HTMLSelectElement>('order').value = order;
    this.listed = this.list.listed(sorted(all, order, this.state.moment));
    this.order = this.listed.flatMap(({ finding }) => (finding === undefined ? [] : [finding]));
    const nothing = all.length > 0 && this.list.filter !== '' ? 'Nothing in the list holds these words.' : none;
    this.findingRows.fill(this.listed, nothing);
    this.markFinding();
  }

  private listRow({ heading, finding }: Listed): HTMLElement {
    return finding === undefined ? make('li', heading, 'heading') : this.findingRow(finding);
  }

  private findingRow(index: number): HTMLElement {
    const finding = this.findings.all[index];
    const item = make('li', '', finding.subdued ? 'dim' : '');
    item.dataset.finding = String(index);
    const row = make('button', '', 'row');
    this.mark(item, row);
    row.append(this.filled(make('span'), finding.row, finding), make('span', [finding.what, ...this.saidOf(finding)].join(' · '), 'what'));
    row.title = textOf(finding.sentence, (object) => isolated(this.data.report.objects[object].name));
    row.onclick = () => this.actions.choose(index);
    item.append(row);
    return item;
  }

  private saidOf({ a, b }: Finding): string[] {
    if (a === undefined || b === undefined) return [];
    const { objects } = this.data.report;
    const { status, comment } = this.review.of(objects[a].name, objects[b].name);
    return [...(status === 'open' ? [] : [status]), ...(comment ? [comment] : [])];
  }

  markFinding(): void {
    const chosen = this.state.finding;
    if (chosen !== undefined) this.findingRows.reveal(this.listed.findIndex(({ finding }) => finding === chosen));
    for (const item of this.findingRows.rows) this.mark(item, item.querySelector('.row'));
    this.tell();
  }

  private mark(item: HTMLElement, row: Element | null): void {
    const is = item.dataset.finding === String(this.state.finding);
    item.classList.toggle('chosen', is);
    row?.setAttribute('aria-current', String(is));
  }

  private tell(): void {
    const index = this.state.finding;
    element('found').hidden = index === undefined;
    this.showReview();
    if (index === undefined) return;
    const finding = this.findings.all[index];
    const sentence = element('sentence');
    sentence.replaceChildren();
    this.filled(sentence, finding.sentence, finding);
    element('facts').replaceChildren(...finding.facts.map((fact) => this.filled(make('li'), fact, finding)));
  }

  listObjects(): void {
    const wanted = element<HTMLInputElement>('filter').value.toLowerCase();
    const none = this.data.report.objects.length === 0 ? 'There is no object.' : 'No object is named so.';
    this.objectRows.fill(this.tree.rows(wanted), none);
  }

  private objectRow(row: Row): HTMLElement {
    const { state } = this;
    const item = make('li', '', row.objects.every((object) => isDim(state, object)) ? 'dim' : '');
    item.setAttribute('aria-level', String(row.depth + 1));
    item.style.paddingLeft = `${Math.min(row.depth, 12) * 14}px`;
    item.append(row.node === undefined ? this.swatch(row.objects[0]) : this.folder(row.node, row.name), this.nameButton(row));
    item.append(
      this.toggle(row, 'hide', 'hidden', 'Hide'),
      this.toggle(row, 'ghost', 'ghosts', 'Show as a ghost'),
      this.toggle(row, 'only', 'only', 'Show it alone'),
    );
    return item;
  }

  private swatch(object: number): HTMLElement {
    const swatch = make('span', '', 'swatch');
    swatch.style.background = `#${this.actions.colourOf(object).toString(16).padStart(6, '0')}`;
    return swatch;
  }

  /// Folds what is under a node away, and back.
  private folder(node: number, name: string): HTMLElement {
    const { folded } = this.tree;
    const made = make('button', folded.has(node) ? '▸' : '▾', 'fold');
    made.dataset.key = `fold ${node}`;
    made.setAttribute('aria-expanded', String(!folded.has(node)));
    made.setAttribute('aria-label', `What is under ${isolated(name)}`);
    made.onclick = () => {
      if (!folded.delete(node)) folded.add(node);
      this.listObjects();
    };
    return made;
  }

  private nameButton(row: Row): HTMLElement {
    const made = make('button', '', 'row');
    const objects = this.data.report.objects;
    const name = make('span');
    name.append(nameIn(row.name));
    const triangles = row.objects.reduce((sum, i) => sum + objects[i].triangles, 0);
    const held = [countText(row.objects.length, 'object'), ...(triangles > 0 ? [countText(triangles, 'triangle')] : [])].join(', ');
    const object = objects[row.objects[0]];
    made.append(name, make('span', row.node === undefined ? describe(object) : held, 'what'));
    made.title = row.node === undefined ? `${isolated(object.name)}\n${isolated(object.source)}\npose ${object.pose.map(numberText).join(' ')}` : isolated(row.name);
    made.dataset.key = row.key;
    made.onclick = () => this.actions.focus(row.objects);
    return made;
  }

  private toggle(row: Row, text: string, what: 'hidden' | 'ghosts' | 'only', tells: string): HTMLElement {
    const made = make('button', text, 'small');
    made.dataset.key = `${text} ${row.key}`;
    made.setAttribute('aria-pressed', String(isSetFor(this.state, row.objects, what)));
    made.setAttribute('aria-label', `${tells}: ${isolated(row.name)}`);
    made.title = tells;
    made.onclick = () => this.actions.toggle(row.objects, what);
    return made;
  }
}

function describe(object: { shape: string; triangles: number; solid: boolean }): string {
  const size = object.triangles > 0 ? `, ${countText(object.triangles, 'triangle')}` : '';
  return `${object.shape}${size}, ${object.solid ? 'solid' : 'surface'}`;
}
