// How the scene is drawn: shapes in the footprint's frame [m] as lines on a canvas.

const ARROW_TIME = 1;  // [s] of motion that an arrow shows

/** A canvas that is as fine as the screen; drawing is in CSS pixels. */
function sharpContext(canvas) {
  const ratio = window.devicePixelRatio || 1;
  const {clientWidth: width, clientHeight: height} = canvas;
  canvas.width = Math.round(width * ratio);
  canvas.height = Math.round(height * ratio);
  const context = canvas.getContext('2d');
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  return {context, width, height};
}

/** Needs `pen` (a context), `size` of the canvas and `scale`, both in pixels, and `unit` [m]. */
class Brush {
  toScreen([x, y]) {
    return [this.size[0] / 2 + x * this.scale, this.size[1] / 2 - y * this.scale];
  }

  /** The path of a circle, or of an outline rounded by its radius. */
  outline(obstacle) {
    const vertices = verticesOf(obstacle);
    this.pen.beginPath();
    if (vertices.length === 0) {
      const [x, y] = this.toScreen(obstacle.position);
      this.pen.arc(x, y, Math.max(obstacle.radius * this.scale, 2.5), 0, 2 * Math.PI);
      return;
    }
    this.traceRounded(vertices.map((vertex) => this.toScreen(vertex)), obstacle.radius * this.scale);
  }

  /** All round a line or polygon on the screen, at a distance [pixels]. Where edges are shorter than
      the distance, a dent is drawn with loops. */
  traceRounded(vertices, distance) {
    const next = (i) => vertices[(i + 1) % vertices.length];
    const area = vertices.reduce((sum, v, i) => sum + v[0] * next(i)[1] - next(i)[0] * v[1], 0);
    const path = area < 0 ? [...vertices].reverse() : vertices;
    const normals = path.map((v, i) => {
      const w = path[(i + 1) % path.length];
      return Math.atan2(v[0] - w[0], w[1] - v[1]);
    });
    path.forEach(([x, y], i) => {
      const before = normals[(i + path.length - 1) % path.length];
      const turn = Math.atan2(Math.sin(normals[i] - before), Math.cos(normals[i] - before));
      const isBack = Math.abs(turn) > 3.14159;  // round the end of a line
      this.pen.arc(x, y, distance, before, before + (isBack ? Math.PI : turn), !isBack && turn < 0);
    });
    this.pen.closePath();
  }

  path(vertices, closed = true) {
    this.pen.beginPath();
    this.trace(vertices, closed);
  }

  trace(vertices, closed) {
    vertices.forEach((vertex, i) => {
      if (i) this.pen.lineTo(...this.toScreen(vertex));
      else this.pen.moveTo(...this.toScreen(vertex));
    });
    if (closed) this.pen.closePath();
  }

  stroke(look) {
    const {width, dash, gap} = styles[look];
    const pixels = (length) => length * this.unit * this.scale;
    this.pen.strokeStyle = colourOf(look);
    this.pen.lineWidth = Math.min(8, Math.max(1.2 + 20 * width, pixels(width)));
    this.pen.setLineDash(dash ? [Math.max(3, pixels(dash)), Math.max(3, pixels(gap))] : []);
    this.pen.stroke();
    this.pen.setLineDash([]);
  }

  strokeGhost(look) {
    this.pen.strokeStyle = colourOf(look);
    this.pen.lineWidth = 1.6;
    this.pen.setLineDash([6, 4]);
    this.pen.stroke();
    this.pen.setLineDash([]);
  }

  dot(point, look) {
    const [x, y] = this.toScreen(point);
    this.pen.beginPath();
    this.pen.arc(x, y, 4.5, 0, 2 * Math.PI);
    this.pen.fillStyle = colourOf(look);
    this.pen.fill();
    this.pen.strokeStyle = themeColour('text');
    this.pen.lineWidth = 1;
    this.pen.stroke();
  }

  /** One second of motion; nothing for what stands. */
  drawArrow(from, velocity, colour, width) {
    const [x, y] = this.toScreen(from);
    const [tx, ty] = this.toScreen(from.map((p, axis) => p + ARROW_TIME * velocity[axis]));
    const length = Math.hypot(tx - x, ty - y);
    if (length < 3) return;
    const head = Math.min(8, length / 2);
    const direction = Math.atan2(ty - y, tx - x);
    const pen = this.pen;
    pen.strokeStyle = colour;
    pen.lineWidth = width;
    pen.beginPath();
    pen.moveTo(x, y);
    pen.lineTo(tx, ty);
    for (const side of [-0.45, 0.45]) {
      pen.moveTo(tx, ty);
      pen.lineTo(tx - head * Math.cos(direction + side), ty - head * Math.sin(direction + side));
    }
    pen.stroke();
  }

  /** Text that stays readable over lines. */
  write(text, x, y, align, colour, size = 12) {
    const pen = this.pen;
    pen.font = `${size}px system-ui, "DejaVu Sans", sans-serif`;
    pen.textAlign = align;
    pen.strokeStyle = themeColour('stage');
    pen.lineWidth = 3;
    pen.strokeText(text, x, y);
    pen.fillStyle = colour;
    pen.fillText(text, x, y);
  }
}
