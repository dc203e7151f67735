"""Time to collision and closest approach by another method than the package's, to compare with.

The gap is computed anew for every time asked for, and cannot change faster than the fastest points
of the body and the obstacle together: what an interval can hold follows from its middle. Points and
vectors are complex numbers, in the body's frame at t = 0.
"""
import cmath
import heapq
import itertools
import math

MOMENT = 1e-9  # [s] to which a first contact is found
BRIEF = 0.01  # [s] in which a gap is taken to have one minimum at most
_GOLDEN = (5 ** 0.5 - 1) / 2


def cross(a, b):
    return (a.conjugate() * b).imag


def distance_to_segment(p, a, b):
    along, offset = b - a, p - a
    squared = abs(along) ** 2
    where = (along.conjugate() * offset).real / squared if squared else 0
    return abs(offset - min(1, max(0, where)) * along)


def distance_of_segments(a, b, c, d):
    if (cross(b - a, c - a) > 0) != (cross(b - a, d - a) > 0) and \
            (cross(d - c, a - c) > 0) != (cross(d - c, b - c) > 0):
        return 0
    return min(distance_to_segment(a, c, d), distance_to_segment(b, c, d),
               distance_to_segment(c, a, b), distance_to_segment(d, a, b))


class Body:
    """A footprint with a constant twist, as felt on board."""

    def __init__(self, vertices, velocity=0, yaw_rate=0):
        self.vertices, self.velocity, self.yaw_rate = vertices, velocity, yaw_rate
        self.segments = list(zip(vertices, vertices[1:] + vertices[:1]))
        self.speed = abs(velocity) + abs(yaw_rate) * max(abs(v) for v in vertices)  # of any point

    def pose(self, t):
        """Position and direction: straight ahead, or round the centre of rotation."""
        if self.yaw_rate == 0:
            return self.velocity * t, 1
        centre = 1j * self.velocity / self.yaw_rate
        turn = cmath.exp(1j * self.yaw_rate * t)
        return centre - centre * turn, turn


class Obstacle:
    """A disc, or the outline of one: two vertices, or a closed polygon."""

    def __init__(self, position, velocity=0, acceleration=0, radius=0, radius_rate=0, outline=()):
        self.position, self.velocity, self.acceleration = position, velocity, acceleration
        self.radius, self.radius_rate, self.outline = radius, radius_rate, tuple(outline)

    def seen_from(self, position, direction):
        """The same one in the frame that is there."""
        return Obstacle((self.position - position) / direction, self.velocity / direction,
                        self.acceleration / direction, self.radius, self.radius_rate,
                        [vertex / direction for vertex in self.outline])

    def speed(self, horizon):
        return abs(self.velocity) + abs(self.acceleration) * horizon + self.radius_rate

    def shape(self, body, t):
        """Radius, and centre or vertices as seen from the body then."""
        position, direction = body.pose(t)
        moved = self.position + t * (self.velocity + t / 2 * self.acceleration) - position
        return (self.radius + t * self.radius_rate,
                [(moved + vertex) / direction for vertex in self.outline or (0,)])


class Approach:
    """An obstacle, and one segment of a body."""

    def __init__(self, body, segment, obstacle, horizon):
        self.body, self.segment, self.obstacle, self.horizon = body, segment, obstacle, horizon
        self.speed = body.speed + obstacle.speed(horizon)  # at most, of the gap

    def gap(self, t):
        radius, shape = self.obstacle.shape(self.body, t)
        if len(shape) == 1:
            return distance_to_segment(shape[0], *self.segment) - radius
        edges = zip(shape, shape[1:] + shape[:1]) if len(shape) > 2 else [shape]
        return min(distance_of_segments(*edge, *self.segment) for edge in edges) - radius

    def first_contact(self, until):
        """Time, or None."""
        return 0 if self.gap(0) <= 0 else self._first_contact(0, until)

    def _first_contact(self, start, end):
        middle = (start + end) / 2
        if self.gap(middle) > self.speed * (end - start) / 2:
            return None
        if end - start < MOMENT:
            return middle
        first = self._first_contact(start, middle)
        return self._first_contact(middle, end) if first is None else first

    def smallest_gap(self, start, end):
        """(gap, when) between two times between which there is only one minimum."""
        while end - start > MOMENT:
            first, second = end - _GOLDEN * (end - start), start + _GOLDEN * (end - start)
            if self.gap(first) <= self.gap(second):
                end = second
            else:
                start = first
        return min((self.gap(t), t) for t in (start, end))


def closest_approach(approaches, until):
    """(smallest gap, when) of all of them; infinite without any."""
    numbers = itertools.count()  # so that what has equal bounds need not be compared further
    best = min(((approach.gap(0), 0) for approach in approaches), default=(math.inf, math.nan))
    waiting = [(best[0] - a.speed * until, next(numbers), a, 0, until) for a in approaches]
    heapq.heapify(waiting)
    while waiting and waiting[0][0] < best[0]:
        _, _, approach, start, end = heapq.heappop(waiting)
        if end - start < BRIEF:
            best = min(best, approach.smallest_gap(start, end))
            continue
        middle = (start + end) / 2
        gap = approach.gap(middle)
        best = min(best, (gap, middle))
        for part in (start, middle), (middle, end):
            bound = gap - approach.speed * (end - start) / 2
            heapq.heappush(waiting, (bound, next(numbers), approach, *part))
    return best
