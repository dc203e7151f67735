// Where things are later: the motions that the predictor assumes, in the footprint's frame of now.

/** Pose {position, cos, sin} of the footprint after t seconds, along a straight line or an arc. */
function poseAfter(twist, t) {
  const turned = twist.angular * t;
  const [vx, vy] = twist.linear;
  // sin(a)/a and (1 - cos(a))/a, which are exact for small angles too
  const along = Math.abs(turned) < 1e-6 ? 1 : Math.sin(turned) / turned;
  const across = Math.abs(turned) < 1e-6 ? turned / 2 : (1 - Math.cos(turned)) / turned;
  return {
    position: [t * (vx * along - vy * across), t * (vx * across + vy * along)],
    cos: Math.cos(turned), sin: Math.sin(turned),
  };
}

function posed(pose, [x, y]) {
  return [pose.position[0] + pose.cos * x - pose.sin * y, pose.position[1] + pose.sin * x + pose.cos * y];
}

/** The obstacle after t seconds. */
function obstacleAfter(obstacle, t) {
  const at = (axis) => obstacle.position[axis] +
    t * (obstacle.velocity[axis] + 0.5 * t * obstacle.acceleration[axis]);
  return {...obstacle, position: [at(0), at(1)], radius: obstacle.radius + obstacle.growth * t};
}

/** Vertices of an obstacle's outline where it is; empty for a circle. */
function verticesOf(obstacle) {
  return obstacle.outline.map(([x, y]) => [x + obstacle.position[0], y + obstacle.position[1]]);
}

/** The obstacle that is touched first; undefined when there is none, or it is not known. */
function firstTouched(frame) {
  if (!frame.scene || !Number.isFinite(frame.ttc)) return undefined;
  return frame.scene.obstacles.find((o) => o.id === frame.id && Math.abs(o.ttc - frame.ttc) < 2e-3) ||
    frame.scene.obstacles.find((o) => Math.abs(o.ttc - frame.ttc) < 2e-3);
}

/** Radius of the circle about the frame's origin that holds the path. */
function reach(path) {
  return Math.max(0, ...path.map(([x, y]) => Math.hypot(x, y)));
}
