"""Time to collision by another method than the package's, to compare with.

A segment is convex, so the distance to it of a point that moves in a straight line is a convex
function of time: its minimum is found by golden sections, the first contact before it by bisection.
"""
import math

_GOLDEN = (math.sqrt(5) - 1) / 2


def distance_to_segment(p, a, b):
    along = (b[0] - a[0], b[1] - a[1])
    offset = (p[0] - a[0], p[1] - a[1])
    where = (offset[0] * along[0] + offset[1] * along[1]) / (along[0] ** 2 + along[1] ** 2)
    where = min(1.0, max(0.0, where))
    return math.hypot(offset[0] - where * along[0], offset[1] - where * along[1])


class Approach:
    """A circle in straight motion, and a segment."""

    def __init__(self, position, velocity, radius, start, end):
        self.position, self.velocity, self.radius = position, velocity, radius
        self.start, self.end = start, end

    def gap(self, t):
        p = (self.position[0] + t * self.velocity[0], self.position[1] + t * self.velocity[1])
        return distance_to_segment(p, self.start, self.end) - self.radius

    def closest_time(self, horizon):
        low, high = 0.0, horizon
        while high - low > 1e-9:
            first, second = high - _GOLDEN * (high - low), low + _GOLDEN * (high - low)
            if self.gap(first) <= self.gap(second):
                high = second
            else:
                low = first
        return min((0.0, low, high, horizon), key=self.gap)

    def first_contact(self, horizon):
        """(time or None, smallest gap); the gap is only a bound where contact is out of reach."""
        gap = self.gap(0)
        if gap <= 0:
            return 0.0, gap
        reach = math.hypot(*self.velocity) * horizon
        if gap > reach * (1 + 1e-9):
            return None, gap - reach
        touching = self.closest_time(horizon)
        smallest = self.gap(touching)
        if smallest > 0:
            return None, smallest
        free = 0.0
        while touching - free > 1e-12:
            middle = (free + touching) / 2
            if self.gap(middle) > 0:
                free = middle
            else:
                touching = middle
        return touching, smallest
