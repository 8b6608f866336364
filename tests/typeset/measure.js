// Runs in the browser: sets a page at several widths, each in a frame of its own, and says what is to be seen.
// What it finds stands as JSON in the document, from which `screen.rs` reads it.

const WIDTHS = [1200, 360];
const page = JSON.parse(document.getElementById('page').textContent);
const pen = document.createElement('canvas').getContext('2d');

const frames = WIDTHS.map(width => {
  const frame = document.createElement('iframe');
  frame.style.cssText = `width: ${width}px; height: 900px; border: 0`;
  frame.srcdoc = page;
  document.body.append(frame);
  return frame;
});

addEventListener('load', () => {
  const found = frames.map(frame => measured(frame.contentDocument, frame.clientWidth));
  const told = document.createElement('script');
  told.type = 'application/json';
  told.id = 'measured';
  told.textContent = JSON.stringify(found).replaceAll('<', '\\u003c');
  document.body.replaceChildren(told);
});

function measured(sheet, width) {
  const formulas = [...sheet.querySelectorAll('math')];
  const root = sheet.documentElement;
  return {
    width,
    reach: root.scrollWidth,
    window: root.clientWidth,
    formulas: formulas.length,
    fractions: sheet.querySelectorAll('mfrac').length,
    faults: formulas.flatMap(math => wrong(math).map(fault => `${place(math)}: ${fault}`)),
    diagrams: [...sheet.querySelectorAll('svg')].map(ink),
    margins: margins(sheet),
  };
}

// The words by which a reader would find an element.
function place(element) {
  const around = element.closest('p, td, dd, .equation, section') ?? element;
  return `“${around.textContent.trim().replace(/\s+/g, ' ').slice(0, 60)}”`;
}

// What is wrong with a formula.
function wrong(math) {
  const faults = [];
  const whole = box(math);
  if (whole.width < 1 || whole.height < 1) faults.push(`fills ${whole.width} by ${whole.height} pixels`);
  if (math.querySelector('merror')) faults.push('is an error');
  for (const fraction of math.querySelectorAll('mfrac')) {
    const [above, below] = [...fraction.children].map(box);
    if (below.top - above.bottom < 0.5) faults.push('has a fraction without a bar');
    if (Math.abs(middle(above) - middle(below)) > 1) faults.push('has a fraction whose parts are not above each other');
  }
  for (const root of math.querySelectorAll('msqrt')) {
    const inner = [...root.children].reduce((sum, child) => sum + box(child).width, 0);
    if (box(root).width < inner + 2) faults.push('has a root without its sign');
  }
  for (const power of math.querySelectorAll('msup')) {
    const [base, script] = [...power.children].map(box);
    if (script.top > base.top + 0.25 * base.height || script.left < base.right - 4) faults.push('has a power on its line');
  }
  const outside = [...math.querySelectorAll('mi, mn, mo, mtext')].map(box)
    .some(piece => piece.left < whole.left - 2 || piece.right > whole.right + 2);
  if (outside) faults.push('leaves its box');
  for (let around = math.parentElement; around; around = around.parentElement) {
    const style = getComputedStyle(around);
    const [across, down] = [style.overflowX, style.overflowY].map(overflow => overflow !== 'visible');
    const [outer, slack] = [box(around), 1.5];
    if (across && (whole.left < outer.left - slack || whole.right > outer.right + slack)) faults.push('is cut off at a side');
    if (down && (whole.top < outer.top - slack || whole.bottom > outer.bottom + slack)) faults.push('is cut off above or below');
  }
  return faults;
}

function box(element) { return element.getBoundingClientRect(); }

function middle(rectangle) { return (rectangle.left + rectangle.right) / 2; }

// Points along the strokes of a picture and the boxes of its letters, as shares of its width.
function ink(svg) {
  const whole = box(svg);
  const share = (x, y) => [(x - whole.left) / whole.width, (y - whole.top) / whole.width];
  const strokes = [...svg.querySelectorAll('path, line, circle, ellipse, rect, polyline, polygon')];
  const lines = strokes.filter(stroke => !stroke.closest('defs')).map(stroke => {
    return along(stroke).map(([x, y]) => share(x, y));
  });
  const letters = [];
  const walker = svg.ownerDocument.createTreeWalker(svg, NodeFilter.SHOW_TEXT);
  for (let node = walker.nextNode(); node; node = walker.nextNode()) {
    if (!node.parentElement.closest('text, foreignObject')) continue;
    for (const filled of inked(node)) letters.push([share(filled[0], filled[1]), share(filled[2], filled[3])]);
  }
  return { lines, letters, width: whole.width };
}

// Points along a stroke, a pixel from each other at most. A browser that is asked for points at lengths begins anew at
// every one, so the lines and curves of a path are followed here; any other stroke is asked.
function along(stroke) {
  const { a, b, c, d, e, f } = stroke.getScreenCTM();
  const shown = ([x, y]) => [a * x + c * y + e, b * x + d * y + f];
  const sections = followed(stroke.getAttribute('d') ?? '');
  if (!sections) {
    const length = stroke.getTotalLength();
    return Array.from({ length: 257 }, (_, step) => {
      const { x, y } = stroke.getPointAtLength(length * step / 256);
      return shown([x, y]);
    });
  }
  return sections.flatMap(section => {
    const corners = section.map(shown);
    const far = corners.slice(1).reduce((sum, [x, y], at) => sum + Math.hypot(x - corners[at][0], y - corners[at][1]), 0);
    const steps = Math.max(8, Math.ceil(far));
    return Array.from({ length: steps + 1 }, (_, step) => between(corners, step / steps));
  });
}

// The lines and curves of a path, each by its corners; nothing if there is more to it.
function followed(path) {
  const sections = [];
  let at;
  for (const [whole, command, numbers] of path.matchAll(/([a-z])([^a-z]*)/gi)) {
    const values = numbers.match(/-?[\d.]+/g)?.map(Number) ?? [];
    const points = Array.from({ length: values.length / 2 }, (_, place) => [values[2 * place], values[2 * place + 1]]);
    if (command === 'Z') continue; // the sides are there already
    const count = { M: 1, L: 1, C: 3 }[command];
    if (!count || points.length !== count) return undefined;
    if (command !== 'M') sections.push([at, ...points]);
    at = points.at(-1);
  }
  return sections.length ? sections : undefined;
}

// The place on a line or a Bézier curve after a share of it: the corners drawn together, by de Casteljau.
function between(corners, share) {
  if (corners.length === 1) return corners[0];
  return between(corners.slice(1).map((to, place) => to.map((end, axis) => corners[place][axis] * (1 - share) + end * share)), share);
}

// What each letter of a run really fills: as wide as it is set, as high as its ink.
function inked(node) {
  const style = getComputedStyle(node.parentElement);
  pen.font = `${style.fontStyle} ${style.fontWeight} ${style.fontSize} ${style.fontFamily}`;
  const range = node.ownerDocument.createRange();
  const found = [];
  for (let at = 0; at < node.length; at++) {
    const letter = node.data[at];
    range.setStart(node, at);
    range.setEnd(node, at + 1);
    const set = range.getBoundingClientRect();
    if (!letter.trim() || set.width === 0) continue;
    const size = pen.measureText(letter);
    const scale = set.height / (size.fontBoundingBoxAscent + size.fontBoundingBoxDescent);
    const foot = set.top + size.fontBoundingBoxAscent * scale;
    found.push([set.left, foot - size.actualBoundingBoxAscent * scale, set.right, foot + size.actualBoundingBoxDescent * scale]);
  }
  return found;
}

// What the page asks of a printer: top, right, bottom and left.
function margins(sheet) {
  const rules = [...sheet.styleSheets].flatMap(style => [...style.cssRules]);
  const asked = rules.find(rule => rule instanceof sheet.defaultView.CSSPageRule);
  return ['Top', 'Right', 'Bottom', 'Left'].map(side => asked?.style[`margin${side}`] ?? '');
}
