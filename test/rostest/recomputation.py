"""What the node said of recorded moments, compared with a recomputation (approach.py)."""
import collections
import math

from approach import Approach, closest_approach, distance_to_segment

TIME_TOLERANCE = 1e-6  # [s]
GAP_TOLERANCE = 1e-6  # [m]

# stamp of a message, and what body is among what obstacles then
Moment = collections.namedtuple('Moment', 'stamp body obstacles')


def compare(test_case, moments, node, horizon, graze, every):
    """Of all moments the segments, and of every so many also the closest approach; what came of it
    is printed and returned.

    graze: [m] within which a contact may be seen or not, since time is ill-conditioned there
    """
    predictions = node.predictions.messages
    # The last of a stamp: what an older message has become by then may bear it too.
    warnings = {warning.header.stamp: warning for warning in node.warnings.messages}
    times_sent = collections.Counter(moment.stamp for moment in moments)
    tally = collections.Counter(messages=len(moments))
    for index, (moment, prediction) in enumerate(zip(moments, predictions)):
        where = 'message %d' % index
        test_case.assertEqual(prediction.header.stamp, moment.stamp, where)
        recomputed = _Recomputed(test_case, moment, horizon, graze, where)
        tally += recomputed.check_segments(prediction.segments)
        if times_sent[moment.stamp] == 1:
            tally += recomputed.check_warning(warnings[moment.stamp], prediction.segments,
                                              index % every == 0)
    print('\n' + ', '.join('%d %s' % (count, what) for what, count in tally.items()))
    test_case.assertLess(tally['late'], 0.05 * len(moments))
    return tally


class _Recomputed:
    """All segments of a body among obstacles."""

    def __init__(self, test_case, moment, horizon, graze, where):
        self.test_case, self.horizon, self.graze, self.where = test_case, horizon, graze, where
        self.obstacles = moment.obstacles
        self.approaches = [[Approach(moment.body, segment, obstacle, horizon)
                            for obstacle in moment.obstacles] for segment in moment.body.segments]

    def check_segments(self, segments):
        self.test_case.assertEqual(len(segments), len(self.approaches), self.where)
        tally = collections.Counter()
        for number, (segment, approaches) in enumerate(zip(segments, self.approaches)):
            tally['grazes'] += self._check_segment(number, segment, approaches)
            if segment.collision_predicted:
                is_outline = bool(self.obstacles[segment.obstacle_index].outline)
                tally['contacts with outlines' if is_outline else 'contacts with circles'] += 1
        return tally

    def _check_segment(self, number, segment, approaches):
        """Whether it had to be compared as a graze."""
        expected = self._first_contact(approaches)
        found = segment.time_to_collision
        where = '%s, segment %d: found %r, expected %r' % (self.where, number, found, expected)
        if segment.collision_predicted:
            self._check_contact(segment, approaches[segment.obstacle_index], where)
        if found == expected or abs(found - expected) <= TIME_TOLERANCE:
            return False
        gap, _ = closest_approach(approaches, min(found, self.horizon))
        self.test_case.assertLessEqual(abs(gap), self.graze, where)
        return True

    def _first_contact(self, approaches):
        first = math.inf
        for approach in approaches:
            contact = approach.first_contact(min(first, self.horizon))
            first = first if contact is None else contact
        return first

    def _check_contact(self, segment, approach, where):
        """The obstacle that is named touches the segment where and when it is said to."""
        time = segment.time_to_collision
        gap = approach.gap(time)
        self.test_case.assertLessEqual(abs(gap) if time > 0 else gap, self.graze, where)
        point = complex(segment.contact_point.x, segment.contact_point.y)
        self.test_case.assertLessEqual(distance_to_segment(point, *approach.segment),
                                       GAP_TOLERANCE, where)
        at_point = Approach(approach.body, (point, point), approach.obstacle, self.horizon)
        self.test_case.assertAlmostEqual(at_point.gap(time), gap, delta=GAP_TOLERANCE, msg=where)

    def check_warning(self, warning, segments, also_closest):
        """Of obstacles none of which is inside the body."""
        if warning.reason & warning.REASON_DEADLINE:  # the machine was busy with other things
            return collections.Counter(late=1)
        test_case, where = self.test_case, '%s: %s' % (self.where, warning)
        everything = [approach for row in self.approaches for approach in row]
        test_case.assertEqual(warning.reason, 0, where)
        test_case.assertEqual(warning.obstacle_count, len(self.obstacles), where)
        test_case.assertEqual(warning.time_to_collision,
                              min(segment.time_to_collision for segment in segments), where)
        clearance = min((approach.gap(0) for approach in everything), default=math.inf)
        test_case.assertAlmostEqual(warning.clearance, clearance, delta=1e-9, msg=where)
        if warning.collision_predicted:
            test_case.assertEqual(warning.closest_distance, 0, where)
            test_case.assertEqual(warning.closest_time, warning.time_to_collision, where)
        elif also_closest:
            smallest, _ = closest_approach(everything, self.horizon)
            then = min((a.gap(warning.closest_time) for a in everything), default=math.inf)
            for distance in warning.closest_distance, then:
                test_case.assertAlmostEqual(distance, smallest, delta=GAP_TOLERANCE, msg=where)
            return collections.Counter({'closest approaches': 1})
        return collections.Counter()
