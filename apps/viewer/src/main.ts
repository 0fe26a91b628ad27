// Puts the page together: data, viewer, buttons and keys.
import { PageData } from './data';
import { copyLink, savePicture } from './export';
import type { Look } from './objects';
import { element, make } from './panels';
import { Viewer } from './viewer';

const keys: [string, string, string][] = [
  ['n', 'N', 'next in the list'],
  ['p', 'P', 'previous in the list'],
  ['Escape', 'Esc', 'back to all'],
  ['f', 'F', 'show everything; of what is chosen the place, then the pair'],
  ['1', '1 2 3', 'look along X, Y, Z'],
  ['c', 'C', 'cut with a plane, or no longer'],
  ['m', 'M', 'measure between two points, or no longer'],
  ['/', '/', 'filter the list'],
  ['g', 'G', 'the rest as ghosts, shown or hidden'],
  ['x', 'X', 'see through the objects'],
  ['r', 'R', 'ground grid'],
  ['b', 'B', 'names and numbers in the picture'],
  ['h', 'H', 'panels'],
  ['t', 'T', 'dark or light'],
  ['s', 'S', 'save a picture'],
  [' ', 'Space', 'play or pause, where there is time'],
  [',', ', .', 'the moment before, the one after'],
  ['l', 'L', 'copy a link to this view'],
  ['ArrowLeft', '← → ↑ ↓', 'turn; with Shift move'],
  ['+', '+ −', 'zoom'],
  ['?', '?', 'these keys'],
];

const nextRest: Record<Look, Look> = { ghost: 'hidden', hidden: 'shown', shown: 'ghost' };

function actionsOf(viewer: Viewer): Record<string, () => void> {
  const { stage } = viewer;
  const go = (step: number) => viewer.choose(viewer.panels.neighbour(step) ?? viewer.state.finding);
  const isUp = viewer.data.header.up;
  const along = { x: [0, 0], y: isUp === 'z' ? [-Math.PI / 2, 0] : [-Math.PI / 2, 9], z: isUp === 'z' ? [-Math.PI / 2, 9] : [-Math.PI / 2, 0] };
  const look = (axis: 'x' | 'y' | 'z') => () => stage.orbit.look(along[axis][0], along[axis][1]);
  return {
    fit: () => (viewer.state.finding === undefined ? viewer.frame() : viewer.fit()),
    cut: () => viewer.toggleSection(),
    measure: () => viewer.toggleMeasure(),
    'section-flip': () => viewer.cut({ flipped: !viewer.section?.flipped }),
    'save-review': () => viewer.saveReview(),
    'open-review': () => element<HTMLInputElement>('review-file').click(),
    'find-clash': () => element('clash-filter').focus(),
    'view-x': look('x'),
    'view-y': look('y'),
    'view-z': look('z'),
    rest: () => viewer.change((state) => (state.rest = nextRest[state.rest])),
    through: () => viewer.change((state) => (state.through = !state.through)),
    grid: () => viewer.change((state) => (state.grid = !state.grid)),
    labels: () => viewer.change((state) => (state.labels = !state.labels)),
    panels: () => viewer.change((state) => (state.panels = !state.panels)),
    theme: () => viewer.change((state) => (state.theme = state.theme === 'dark' ? 'light' : 'dark')),
    picture: () => savePicture(viewer),
    link: () => void copyLink(viewer),
    help: () => element<HTMLDialogElement>('keys').showModal(),
    previous: () => go(-1),
    next: () => go(1),
    leave: () => viewer.choose(undefined),
    play: () => viewer.time.toggle(),
    before: () => viewer.time.step(-1),
    after: () => viewer.time.step(1),
    'show-all': () => viewer.showAll(),
    'complaint-seen': () => (element('complaint').hidden = true),
  };
}

const actionOfKey: Record<string, string> = {
  n: 'next', j: 'next', p: 'previous', k: 'previous', Escape: 'leave', f: 'fit', '1': 'view-x', '2': 'view-y', '3': 'view-z',
  g: 'rest', x: 'through', r: 'grid', b: 'labels', h: 'panels', t: 'theme', s: 'picture', l: 'link', '?': 'help',
  c: 'cut', m: 'measure', '/': 'find-clash', ' ': 'play', ',': 'before', '.': 'after',
};

/// Arrows and zoom. Whether the key was one of them.
function steer(viewer: Viewer, key: string, moves: boolean): boolean {
  const { orbit } = viewer.stage;
  const ways: Record<string, [number, number]> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
  const way = ways[key];
  if (way && moves) orbit.pan(way[0] * 0.06, way[1] * 0.06);
  else if (way) orbit.turn(way[0] * -0.12, way[1] * 0.12);
  else if (key === '+' || key === '=') orbit.zoom(0.85);
  else if (key === '-') orbit.zoom(1 / 0.85);
  else return false;
  return true;
}

/// A click is a press that does not drag.
function listenToTools(viewer: Viewer, canvas: HTMLElement): void {
  let pressed = { x: 0, y: 0 };
  canvas.addEventListener('pointerdown', (event) => (pressed = { x: event.clientX, y: event.clientY }));
  canvas.addEventListener('pointerup', (event) => {
    if (Math.hypot(event.clientX - pressed.x, event.clientY - pressed.y) < 4) viewer.measureAt(event.clientX, event.clientY);
  });
  const axis = element<HTMLSelectElement>('section-axis');
  axis.onchange = () => viewer.cut({ axis: Number(axis.value) as 0 | 1 | 2 });
  const at = element<HTMLInputElement>('section-at');
  at.oninput = () => viewer.cut({ share: Number(at.value) / 1000 });
  const file = element<HTMLInputElement>('review-file');
  file.onchange = () => {
    const [chosen] = file.files ?? [];
    if (chosen) void chosen.text().then((text) => viewer.openReview(text));
    file.value = ''; // so that the same file can be opened again
  };
  // Only while there is something to lose: a page that listens is slower to leave.
  viewer.review.onChanged = (changed) => {
    window.onbeforeunload = changed ? (event) => event.preventDefault() : null;
  };
}

function listen(viewer: Viewer): void {
  const actions = actionsOf(viewer);
  for (const [id, action] of Object.entries(actions)) document.getElementById(id)?.addEventListener('click', action);
  const canvas = element('canvas');
  canvas.addEventListener('dblclick', (event) => {
    const hit = viewer.stage.hit(event.clientX, event.clientY);
    if (!hit) return viewer.frame();
    viewer.stage.orbit.place.target.copy(hit.point);
    viewer.stage.orbit.zoom(0.5);
  });
  listenToTools(viewer, canvas);
  canvas.addEventListener('pointermove', (event) => {
    if (event.buttons === 0) viewer.hover(event.clientX, event.clientY);
  });
  document.addEventListener('keydown', (event) => {
    const target = event.target as HTMLElement;
    if (event.ctrlKey || event.metaKey || event.altKey || /^(INPUT|SELECT|TEXTAREA)$/.test(target.tagName)) return;
    if (element<HTMLDialogElement>('keys').open || (event.key === ' ' && target.tagName === 'BUTTON')) return;
    const action = actions[actionOfKey[event.key] ?? ''];
    if (action) action();
    else if (!(target === canvas || target === document.body) || !steer(viewer, event.key, event.shiftKey)) return;
    event.preventDefault();
  });
  const list = document.querySelector('#keys dl');
  for (const [, key, what] of keys) list?.append(make('dt', key), make('dd', what));
}

async function start(): Promise<void> {
  const viewer = new Viewer(await PageData.read());
  listen(viewer);
  window.addEventListener('hashchange', () => location.reload()); // another link was put into the address
  Object.assign(window, { toccata: viewer }); // for tests, and for the curious
}

start().catch((error: unknown) => {
  const notice = element('notice');
  notice.hidden = false;
  notice.textContent = `The page cannot be shown: ${error instanceof Error ? error.message : String(error)}`;
  console.error(error);
});
