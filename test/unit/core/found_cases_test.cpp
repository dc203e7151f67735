// Cases that once broke the guarantee, and some that decide what hardly ever has to be decided, as
// the random suites printed them.
#include <gtest/gtest.h>

#include <cmath>

#include "footprint_collision_predictor/predictor.hpp"
#include "footprint_guarantee.hpp"
#include "guarantee.hpp"

namespace footprint_collision_predictor::test {
namespace {

// Passes the end just outside of what counts as touching the end, and sinks into the inside.
TEST(FoundCase, BetweenTheEndAndTheInside) {
  const Case c{{{0x0p+0, 0x0p+0}, {-0x1.65df45cbc3a57p+3, -0x0p+0}},
               {{0x1.f2c9babc3c152p-5, 0x1.092e3666566bap-5},
                {-0x1.0c2b0eac3edc2p-4, 0x1.c410794bf1dd4p-30},
                {0x1.39129e3e1eea9p-27, -0x1.e6186ab234a6fp-30}},
               0x1.092e36cf708e1p-5,
               0x1.4p+4};
  expectGuarantee(c);
}

// The same at a few km from the origin; overlaps by 13 mm in the end.
TEST(FoundCase, BetweenTheEndAndTheInsideFarAway) {
  const Case c{{{0x1.d1328a785a178p+11, 0x1.658ca7dd7d8b9p+11},
                {0x1.d5295e07ec7c3p+11, 0x1.6c29edd270abbp+11}},
               {{0x1.d128ba0804294p+11, 0x1.6580d79a7e29ep+11},
                {0x1.78e7d320714b4p-4, 0x1.3b5865cb3b06ap-3},
                {0x1.0382d9ecf9a19p-11, 0x1.58d60e1c6a693p-11}},
               0x1.2d65c85acb52bp-4,
               0x1.4p+4};
  expectGuarantee(c);
}

// A point that nearly comes to rest as it moves on to the segment, end-on.
TEST(FoundCase, APointBrakingOntoTheSegment) {
  const Case c{{{-0x1.f8f5d64c9f6ddp+2, -0x1.b84e2241b8922p+0},
                {-0x1.d0e9dc9894a21p+5, -0x1.d258e24f0347dp+5}},
               {{-0x1.d0efb5eb806fap+5, -0x1.d25dc5a47c51ap+5},
                {0x1.bff1d99c0cd9ep-18, 0x1.765a7d777286bp-18},
                {-0x1.0c045aff338d2p-27, -0x1.bff88cd0dc67bp-28}},
               0x0p+0,
               0x1.abdc3f1fa01d4p+11};
  expectGuarantee(c);
}

// Almost rests where it grazes the end: the steps towards the contact must not crawl.
TEST(FoundCase, RestingInAGraze) {
  const Case c{{{-0x1.30fa4591d863ap-1, -0x1.7401e9278ddb3p-1},
                {-0x1.39e7782849635p-1, -0x1.7aad12646c6ep-1}},
               {{-0x1.2bfc68b52c76ap-1, -0x1.9f62ac978145bp-1},
                {0x1.2020284c98de6p-7, 0x1.11bd2ae523c12p-6},
                {-0x1.5c538f1cae8e1p-10, -0x1.425615a2065e4p-10}},
               0x1.3dc863f95a119p-5,
               0x1.4p+4};
  expectGuarantee(c);
}

// Without acceleration: the end is passed by a hair, and the inside entered.
TEST(FoundCase, BetweenTheEndAndTheInsideStraight) {
  const Case c{{{-0x1.4c5344976c893p+1, 0x1.a9c00eba82a2bp+1},
                {-0x1.6b74935728ce5p+0, -0x1.dc867ba54b9c2p+0}},
               {{0x1.b8bab305a0b73p+5, -0x1.f60cddb4b083p+7},
                {-0x1.e427f5528fbddp+2, 0x1.0ad692296bd55p+5},
                {0x0p+0, 0x0p+0}},
               0x1.053cc54f34248p-17,
               0x1.de163b33c8ecdp+3};
  expectGuarantee(c);
}

// Flies hundreds of metres away and back to a place near by, at a shallow angle.
TEST(FoundCase, AShallowBoomerang) {
  const Case c{{{-0x1.2f7241dec3aa2p+1, -0x1.d35e8d503fc18p+1},
                {-0x1.2f8fef0863c0bp+4, 0x1.6e4bb1defca2ep+2}},
               {{-0x1.ead68ad1e3f13p+3, 0x1.d5ef927ea0231p+1},
                {0x1.4dcc441e311d2p+2, -0x1.78f94a71606dfp+1},
                {-0x1.87f56451ff5e8p-6, 0x1.baa8491fcb3fdp-7}},
               0x0p+0,
               0x1.b406ec306f9c7p+9};
  expectGuarantee(c);
}

// What is left of an acceleration that a filter lets decay: not 0, but its square is.
TEST(FoundCase, AnAccelerationTooSmallToBeSquared) {
  const Case c{{{0x1.88p+5, 0x0p+0}, {0x1.88p+5, -0x1p+7}},
               {{0x0p+0, 0x1.6p+5}, {0x1.88p+5, 0x0p+0}, {0x0p+0, -0x0.0002c2c3f6041p-1022}},
               0x1.8p+5,
               0x1.08p+5};
  expectGuarantee(c);
}

// Leaves square to the way to the end, but for less than a double can square: no step led on, and
// giving up was taken for contact.
TEST(FoundCase, SquareToTheEndButForADenormal) {
  const Case c{{{-0x1.b851eb851eb87p-12, -0x1.b851eb851eb87p-12},
                {-0x0.0000000000002p-1022, -0x1.b851eb851eb89p-12}},
               {{0x0p+0, 0x0p+0}, {0x0p+0, 0x0p+0}, {-0x1p+0, 0x0p+0}},
               0x0p+0,
               0x1.7cp+6};
  expectGuarantee(c);
}

// Sinks into the far end of a long segment at a shallow angle: a tenth of a nanometre away the
// rounded coordinates of the end turned the normal so that a step led past the contact.
TEST(FoundCase, IntoTheFarEndAtAShallowAngle) {
  const Case c{{{-0x1.65b8554a4e43dp+2, -0x1.808a09dfc5efap-4},
                {0x1.6db897c59e684p+4, -0x1.b7eb7932e8b7ep+4}},
               {{0x1.6dbab623328f7p+4, -0x1.b7ed8210dcfe3p+4},
                {0x1.2dc63d2fd4fp-20, -0x1.21a69fd875664p-20},
                {-0x1.64c8dcf83d4f5p-7, 0x1.56a4692bcea55p-7}},
               0x0p+0,
               0x1.cea1c4d328efdp+5};
  expectGuarantee(c);
}

// Starts where rounding does not tell whether a vertex or a side is what is nearest.
TEST(FoundCase, FromBetweenAVertexAndASide) {
  FootprintCase c{};
  c.footprint = {{0x1.f298dbf3ffddbp-5, -0x1.6cf32791c7a59p-4},
                 {-0x1.c88480b956c9ep-4, -0x1.e2826f515f722p-6},
                 {-0x1.5357e14981da3p-6, 0x1.b96c1433faf39p-4},
                 {0x1.decd5e5f0df63p-4, 0x1.2d7d40a18423p-5}};
  c.disc = {{{0x1.761824e82c6f7p-4, -0x1.80e9f3b0ad4d4p-6},
             {0x1.7674d6bfc2edp-14, 0x1.a4b397bcd3553p-13},
             {0, 0}},
            0x1.305068c163ep-10,
            0};
  c.horizon = 0x1.ad3b3d0132c11p+2;
  expectFootprintGuarantee(c);
}

// The same of a side of which it is the first that is asked, sliding along it.
TEST(FoundCase, AlongASideWithinRounding) {
  const double x = 0x1.59c727d5e6157p+1, y = 0x1.2330520483717p+1;
  FootprintCase c{};
  c.footprint = {{-x, -y}, {x, -y}, {x, y}, {-x, y}};
  c.disc = {{{-0x1.72bac72a7cb5dp+1, -0x1.cbab2f4c82a64p+0}, {0, 0x1.891e9ccca0bc7p-3}, {0, 0}},
            0x1.8f39f5496a05fp-3,
            0};
  c.horizon = 0x1.2b5382a6b3cadp+4;
  expectFootprintGuarantee(c);
}

// A point that meets a vertex within rounding of one side, but not of the other: both say so.
TEST(FoundCase, AVertexOfWhichOneSideIsTouched) {
  FootprintCase c{};
  c.footprint = {{0x1.eb7dc4e394dp-1, 0x1.7a0560347b744p-1},
                 {-0x1.beaf24b0fa5d8p+0, 0x1.20e5d2a1e9596p+0},
                 {-0x1.47bf9b867428cp-3, -0x1.37eb09452e81bp-1}};
  c.twist.linear = {0x1.a6d6d5facf8f2p-4, 0x1.35db290d0e761p+0};
  c.disc.motion = {{0x1.4b0aef63bce2cp+0, -0x1.19eec13c1f988p+1},
                   {-0x1.645773fa41f2cp-5, 0x1.5f0b2c3e32651p+0},
                   {0, 0}};
  c.horizon = 0x1.832d0a905ac4dp+3;
  expectFootprintGuarantee(c);
  std::vector<std::optional<core::SegmentContact>> contacts;
  firstContacts(core::Polygon(c.footprint), c.twist, core::ObstacleBatch({obstacleOf(c)}),
                c.horizon, &contacts);
  ASSERT_TRUE(contacts[1] && contacts[2]);
  EXPECT_EQ(contacts[1]->contact.time, contacts[2]->contact.time);
}

// A wall in line with a side, 1.1 m away: rounding had them cross.
TEST(FoundCase, AWallInLineWithASide) {
  FootprintCase c{};
  c.footprint = {{0x1.2183e8f3edb62p+1, -0x1.f2bb2560883f1p-1},
                 {0x1.092d3cfd07ea6p+1, 0x1.f52806e13548p-1},
                 {0x1.ae3d88cab886p-3, 0x1.985a5f98de2fdp-1},
                 {0x1.99d4241c8aa0ep-2, -0x1.27c466546fabap+0}};
  c.disc.motion = {{0x1.64e01a0923962p-3, 0x1.2b395d4e80aafp-3}, {0, 0}, {0, 0}};
  c.outline = {{0x1.ca678068bb794p+0, 0x1.edf87257b85a2p+0},
               {0x1.98044434a65c8p+0, 0x1.f9bdb947af549p+1}};
  c.horizon = 1;
  expectFootprintGuarantee(c);
}

// The tiny edge turns inwards, by much: that is not convex.
TEST(FoundCase, ATinyEdgeInAnInnerCorner) {
  FootprintCase c{};
  c.footprint = {{-1, -1}, {0, 0}, {1e-17, 1e-16}, {1, 1}, {-1, 1}};
  c.disc.motion = {{0.5, 0}, {0.06, 0.5}, {0, 0}};
  c.horizon = 10;
  expectFootprintGuarantee(c);
}

// At an acute vertex the side behind seemed to be as near as the one in front.
TEST(FoundCase, BesideAnAcuteVertex) {
  FootprintCase c{};
  c.footprint = {{0, 0},
                 {0x1.282c63284cd0bp-1, 0x1.a1a4853bb8bf8p-1},
                 {0x1.27c16ed47c795p-1, 0x1.a1f0498ff1ae4p-1}};
  c.disc.motion = {{-0x1.3c6e11789a844p-43, 0x1.c05204e87e396p-44},
                   {0x1.27f6e94d1b486p-1, 0x1.a1ca672e126cdp-1},
                   {0x1.2de9cba605c3fp-7, 0x1.5c435f423ff09p-8}};
  c.horizon = 2;
  expectFootprintGuarantee(c);
}

TEST(FoundCase, BesideAnAcuteVertexFromAfar) {
  FootprintCase c{};
  c.footprint = {{0, 0},
                 {-0x1.08f12e4e4889dp+1, 0x1.d1a5267b799b8p+0},
                 {-0x1.08f135a8801f5p+1, 0x1.d1a515bfb541fp+0}};
  c.disc.motion = {{0x1.1ec4d3058152ap+2, -0x1.f801687853b12p+1},
                   {-0x1.dd7512e38809ap-2, 0x1.a392bdb9858b2p-2},
                   {0x1.5b299a3bc2a6bp-25, -0x1.70165fcdbe33p-28}};
  c.horizon = 0x1.0b2453e26d4a8p+4;
  expectFootprintGuarantee(c);
}

// A vertex of the outline added to the obstacle's position far from the origin was rounded there.
TEST(FoundCase, AnOutlineFarFromTheOrigin) {
  FootprintCase c{};
  c.footprint = {{0x1.b18fb349f2f82p+18, -0x1.0307bf1d4b2edp+19},
                 {0x1.b18fbdfafdbd9p+18, -0x1.0307595343eedp+19},
                 {0x1.b18fbdf8aca28p+18, -0x1.03075953345d6p+19}};
  c.disc.motion = {{0x1.b18fadfe66db3p+18, -0x1.03075ad164b9p+19},
                   {0x1.9b31b54fe5cc4p-10, 0x1.e88cc7a3f80d4p-6},
                   {0, 0}};
  c.outline = {{0, 0}, {0x1.f608deea40f2dp-3, -0x1.41e36a4d7b8cdp-5}};
  c.horizon = 0x1.491640eb90e4dp+2;
  expectFootprintGuarantee(c);
}

TEST(FoundCase, AnOutlineFarFromItsOwnPosition) {
  const core::Polygon footprint({{-0.1, -0.1}, {0.1, -0.1}, {0.1, 0.1}, {-0.1, 0.1}});
  const double at = 99999999.3, to_wall = 99999996;
  const core::Obstacle wall({{at, 0}, {-1, 0}, {0, 0}}, 0, 0, {{-to_wall, -1}, {-to_wall, 1}});
  const auto first = firstContact(footprint, {}, wall, 10);
  ASSERT_TRUE(first);
  EXPECT_NEAR(first->contact.time, (at - to_wall) - 0.1, 1e-12);
}

// A tiny line stands within the solid, 2^-52 m from a tiny side.
TEST(FoundCase, AnOutlineHardlyWithin) {
  const double x = 0x1.4d6baee74bc06p+1, y = 0x1.03e5e1c8a04b4p+0;
  FootprintCase c{};
  c.footprint = {{-x, -y}, {x, -y}, {x, -0x1.03e5e1b4caa8bp+0}, {x, y}, {-x, y}};
  c.disc.motion = {{0x1.4aaef0480160cp-2, -0x1.2f4d72f8b4877p+0}, {0, 0}, {0, 0}};
  c.outline = {{0x1.2415d0de4b944p+1, 0x1.5b3c8992a6e1p-3},
               {0x1.2415d0de4b944p+1, 0x1.5b3c89dc8da8p-3}};
  c.horizon = 0x1.0db1a037636b5p-3;
  expectFootprintGuarantee(c);
}

// Both move on fast together, while the footprint hardly turns.
TEST(FoundCase, SideBySideAndHardlyTurning) {
  const double r = 0x1.08b9016453029p-2;
  FootprintCase c{};
  c.footprint = {{-r, -r}, {r, -r}, {r, r}, {-r, r}};
  c.twist = {{0x1.9a7abc44af8bep+10, 0x1.b609b519fa5dfp+10}, -0x1.5dad8fe08ae51p-56};
  c.disc = {
      {{-0x1.0c9cde2dp-2, 0x1.0c6ec5bap-2}, {0x1.9a7abc48a6d76p+10, 0x1.b609b51df1a7cp+10}, {0, 0}},
      0x1.57f1217b7c00ap-8,
      0};
  c.horizon = 0x1.73ed4fdbfdaf6p+7;
  expectFootprintGuarantee(c);
}

// A wall's end lies within a sliver by 4e-18 m. Of the side that it is not behind, since it is
// beyond the ends of that, it is far away.
TEST(FoundCase, HardlyWithinASliver) {
  FootprintCase c{{{0, 0},
                   {-0x1.cde7d96888018p-1, 0x1.fcef0869a4a4p-1},
                   {-0x1.9c1bca821f36dp-1, 0x1.b4dbaebe40919p-1}},
                  {{0, 0}, 0x1.fc18687a97827p-14},
                  {{{0x1.7bf5cb3a29d43p-6, 0x1.fe08393ec03cbp-6}, {0, 0}, {0, 0}}, 0, 0},
                  {{0x1.6960efb0d1828p-2, -0x1.54212205821bdp-2},
                   {-0x1.6960efb0d1828p-2, 0x1.54212205821bdp-2}},
                  0.125};
  expectFootprintGuarantee(c);
  c.twist.angular = 0;
  c.disc.motion.acceleration = {1e-6, 1e-6};
  expectFootprintGuarantee(c);
}

// Thousands of rounds about a pillar, 1e-5 m from it: the allowance for rounding must not grow so.
TEST(FoundCase, ManyRoundsAboutAPillar) {
  const core::Polygon footprint({{-0.5, -2}, {0.5, -2}, {0.5, -1}, {-0.5, -1}});
  const core::Obstacle pillar({{0, 0}, {0, 0}, {0, 0}}, 1 - 1e-5);
  EXPECT_FALSE(firstContact(footprint, {{0, 0}, 10}, pillar, 3600));
}

// A vertex meets a line much longer than the footprint: what rounding leaves of the gap was taken
// for the way from one to the other.
TEST(FoundCase, ClosingSpeedAgainstALongLine) {
  const core::Polygon footprint({{0x1.2a55345f64514p-3, 0x1.92eefada7675bp-1},
                                 {-0x1.28a72a5949269p-3, 0x1.3310427e17454p+0},
                                 {0x1.ec55b8ab3de7dp-3, 0x1.4657951386fdbp+0}});
  const core::Twist twist{{0x1.1901dbf9e7abep+0, 0x1.99d1316a6b886p-3}, 0};
  const core::Motion motion{{0x1.10d21b7249d3p-3, 0x1.23dc0ddce5778p+0},
                            {0x1.f019bc7d1e043p+1, -0x1.98c215ae69399p+1},
                            {0, 0}};
  const core::Vec2 start(-0x1.9b92c047f37cp+2, 0x1.de18173f6f5e8p+1);
  const core::Vec2 end(0x1.0065ad555bf1fp+4, -0x1.94c277093bd38p+2);
  const auto first = firstContact(footprint, twist, core::Obstacle(motion, 0, 0, {start, end}),
                                  0x1.6a2705d90e994p-1);
  ASSERT_TRUE(first);
  EXPECT_NE(first->contact.feature, core::Feature::kInside);
  const core::Vec2 relative = motion.velocity - twist.linear;
  EXPECT_NEAR(first->closing_speed, std::abs(core::cross((end - start).normalized(), relative)),
              1e-9);
}

}  // namespace
}  // namespace footprint_collision_predictor::test
