// What leaves the page: a picture, and a link that restores the view.
import { element, make } from './panels';
import type { Viewer } from './viewer';

/// The canvas with the words over it.
function paint(viewer: Viewer): HTMLCanvasElement {
  const { stage } = viewer;
  stage.drawAll(); // what is drawn is only kept until the browser shows it
  const picture = document.createElement('canvas');
  picture.width = stage.canvas.width;
  picture.height = stage.canvas.height;
  const context = picture.getContext('2d');
  if (!context) return picture;
  context.drawImage(stage.canvas, 0, 0);
  const ratio = stage.canvas.width / stage.canvas.clientWidth;
  context.scale(ratio, ratio);
  context.font = '600 13px system-ui, sans-serif';
  context.textAlign = 'center';
  context.lineWidth = 4;
  const style = getComputedStyle(document.documentElement);
  for (const shown of element('marks').children as unknown as Iterable<HTMLElement>) {
    if (shown.hidden) continue;
    const [x, y] = [parseFloat(shown.style.left), parseFloat(shown.style.top) - 14];
    context.strokeStyle = style.getPropertyValue('--panel');
    context.fillStyle = getComputedStyle(shown).color;
    context.strokeText(shown.textContent ?? '', x, y);
    context.fillText(shown.textContent ?? '', x, y);
  }
  const partial = element('partial');
  if (!partial.hidden) {
    context.textAlign = 'left';
    context.strokeStyle = style.getPropertyValue('--panel');
    context.fillStyle = getComputedStyle(partial).color;
    context.strokeText(partial.textContent ?? '', 12, 22);
    context.fillText(partial.textContent ?? '', 12, 22);
  }
  return picture;
}

export function savePicture(viewer: Viewer): void {
  paint(viewer).toBlob((blob) => {
    if (!blob) return;
    const link = make('a');
    link.href = URL.createObjectURL(blob);
    link.download = `${viewer.data.header.title.replace(/[^\w.-]+/g, '-') || 'toccata'}.png`;
    link.click();
    window.setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
  }, 'image/png');
}

export async function copyLink(viewer: Viewer): Promise<void> {
  const address = location.href.split('#')[0] + viewer.link();
  const button = element('link');
  try {
    await navigator.clipboard.writeText(address);
    button.textContent = 'Copied';
  } catch {
    window.prompt('A link to this view:', address);
  }
  window.setTimeout(() => (button.textContent = 'Link'), 1500);
}
