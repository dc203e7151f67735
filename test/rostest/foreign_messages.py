"""Obstacle messages of packages that are not needed to build or test, defined at run time.

Their md5 sums are what the node tells them by, so they are checked here.
"""
from genpy.dynamic import generate_dynamic


def _definition(root, **parts):
    """The text that a publisher would send: the root, then each message that it is made of."""
    sections = [root]
    for name, fields in parts.items():
        sections.append('MSG: %s\n%s' % (name.replace('__', '/'), fields))
    separator = '\n' + '=' * 80 + '\n'
    return separator.join(section.replace('; ', '\n') + '\n' for section in sections)


_TRIPLE = 'float64 x; float64 y; float64 z'
_HEADER = 'uint32 seq; time stamp; string frame_id'

_obstacle_detector = generate_dynamic('obstacle_detector/Obstacles', _definition(
    'Header header; obstacle_detector/SegmentObstacle[] segments; '
    'obstacle_detector/CircleObstacle[] circles',
    std_msgs__Header=_HEADER,
    obstacle_detector__SegmentObstacle='geometry_msgs/Point first_point; '
                                       'geometry_msgs/Point last_point',
    obstacle_detector__CircleObstacle='geometry_msgs/Point center; geometry_msgs/Vector3 velocity; '
                                      'float64 radius; float64 true_radius',
    geometry_msgs__Point=_TRIPLE,
    geometry_msgs__Vector3=_TRIPLE))

_costmap_converter = generate_dynamic('costmap_converter/ObstacleArrayMsg', _definition(
    'std_msgs/Header header; costmap_converter/ObstacleMsg[] obstacles',
    std_msgs__Header=_HEADER,
    costmap_converter__ObstacleMsg='std_msgs/Header header; geometry_msgs/Polygon polygon; '
                                   'float64 radius; int64 id; '
                                   'geometry_msgs/Quaternion orientation; '
                                   'geometry_msgs/TwistWithCovariance velocities',
    geometry_msgs__Polygon='geometry_msgs/Point32[] points',
    geometry_msgs__Point32='float32 x; float32 y; float32 z',
    geometry_msgs__Quaternion='float64 x; float64 y; float64 z; float64 w',
    geometry_msgs__TwistWithCovariance='geometry_msgs/Twist twist; float64[36] covariance',
    geometry_msgs__Twist='geometry_msgs/Vector3 linear; geometry_msgs/Vector3 angular',
    geometry_msgs__Vector3=_TRIPLE))

ObstacleDetectorObstacles = _obstacle_detector['obstacle_detector/Obstacles']
CostmapConverterObstacles = _costmap_converter['costmap_converter/ObstacleArrayMsg']

if ObstacleDetectorObstacles._md5sum != '043bbf49c7775f8111e850268dbcf2e3':
    raise AssertionError('obstacle_detector/Obstacles is defined wrongly')
if CostmapConverterObstacles._md5sum != '8a1bdcde72c65ca7d3ce8ebf52d43516':
    raise AssertionError('costmap_converter/ObstacleArrayMsg is defined wrongly')


def from_obstacle_detector(obstacles, margin):
    """What obstacle_detector would send: `radius` is the measured one plus a margin; lines have
    neither radius nor velocity."""
    message = ObstacleDetectorObstacles()
    for obstacle in obstacles:
        if obstacle.outline:
            item = _obstacle_detector['obstacle_detector/SegmentObstacle']()
            (item.first_point.x, item.first_point.y), (item.last_point.x, item.last_point.y) = \
                _vertices(obstacle)
            message.segments.append(item)
            continue
        item = _obstacle_detector['obstacle_detector/CircleObstacle']()
        item.center.x, item.center.y = obstacle.position.x, obstacle.position.y
        item.velocity.x, item.velocity.y = obstacle.velocity.x, obstacle.velocity.y
        item.true_radius, item.radius = obstacle.radius, obstacle.radius + margin
        message.circles.append(item)
    return message


def from_costmap_converter(obstacles):
    """What costmap_converter would send: a circle is a polygon of one vertex."""
    message = CostmapConverterObstacles()
    for obstacle in obstacles:
        item = _costmap_converter['costmap_converter/ObstacleMsg']()
        for x, y in _vertices(obstacle):
            item.polygon.points.append(_costmap_converter['geometry_msgs/Point32'](x, y, 0))
        item.id, item.radius = obstacle.id, obstacle.radius
        linear = item.velocities.twist.linear
        linear.x, linear.y = obstacle.velocity.x, obstacle.velocity.y
        message.obstacles.append(item)
    return message


def _vertices(obstacle):
    """In the frame of the message; of a circle its centre."""
    centre = obstacle.position
    if not obstacle.outline:
        return [(centre.x, centre.y)]
    return [(centre.x + vertex.x, centre.y + vertex.y) for vertex in obstacle.outline]
