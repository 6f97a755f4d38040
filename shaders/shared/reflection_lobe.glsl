// SPDX-License-Identifier: Apache-2.0
// The mean of the sky's light over the lobe that a rough surface reflects: a rule whose nodes a shader sums. m is the
// power of gloss.glsl.

// Half the angle from the lobe's axis to where its distribution is 1e-6 of its peak, at most pi/4: cos(t/2)^m = 1e-6.
INLINE Number lobeHalfEnd(Number power) {
  Number cosine = pow(NUMBER(1e-6), NUMBER(1.0) / power);
  return min(atan(sineFromCosine(cosine), cosine), kHalfPi / NUMBER(2.0));
}

// Nodes 0 to 3 of Gauss's rule of four points on [-1, 1], and their weights, which add up to 2.
INLINE Number gaussNode(int i) {
  Number size = i == 0 || i == 3 ? NUMBER(0.86113631159405257522) : NUMBER(0.33998104358485626480);
  return i < 2 ? -size : size;
}
INLINE Number gaussWeight(int i) {
  return i == 0 || i == 3 ? NUMBER(0.34785484513745385737) : NUMBER(0.65214515486254614263);
}

// A circle about the axis of a lobe, at one angle.
struct LobeCircle {
  Number cosine;  // of that angle
  Number sine;
  Number weight;  // of the circle in the sum over circles; not normalised
  Number turn;    // it is above the horizon within so much of its highest point, [0, pi]
};

// Circle i in [0, 8 panels) of the rule for the mean of light over the lobe about `axis`, in which light below the
// horizon is one radiance. The lobe is Blinn-Phong's distribution times n.l for n = v = axis, cos(t/2)^m cos t (Karis,
// "Real Shading in Unreal Engine 4", 2013). Panels end where circles begin to touch the horizon. x^2 (3 - 2 x) in place
// of the angle smooths the square root that begins there.
INLINE LobeCircle lobeCircle(Number power, Number3 axis, int i, int panels) {
  Number end = NUMBER(2.0) * lobeHalfEnd(power);
  Number touch = min(max(elevationOf(axis), -elevationOf(axis)), end);
  bool outer = i >= 4 * panels;
  int k = outer ? i - 4 * panels : i;
  Number x = (Number(k / 4) + NUMBER(0.5) + NUMBER(0.5) * gaussNode(k % 4)) / Number(panels);
  Number from = outer ? touch : NUMBER(0.0);
  Number range = outer ? end - touch : touch;
  Number angle = from + range * x * x * (NUMBER(3.0) - NUMBER(2.0) * x);
  LobeCircle circle;
  circle.cosine = cos(angle);
  circle.sine = sin(angle);
  circle.weight = range * x * (NUMBER(1.0) - x) * gaussWeight(k % 4) * circle.sine *
                  pow(cos(NUMBER(0.5) * angle), power) * max(circle.cosine, NUMBER(0.0));
  Number crossing = -circle.cosine * axis.y;
  Number extent = circle.sine * horizontalLength(axis);
  Number across = extent > max(crossing, -crossing) ? crossing / extent : NUMBER(0.0);
  Number half_turn = atan(sineFromCosine(across), across);
  circle.turn = extent > max(crossing, -crossing) ? half_turn : crossing < NUMBER(0.0) ? kPi : NUMBER(0.0);
  return circle;
}

// Direction j in [0, 4 panels) of a circle's part above the horizon. Its share of that part is gaussWeight(j % 4) /
// (2 panels).
INLINE Number3 lobeDirection(LobeCircle circle, Number3 axis, int j, int panels) {
  Number at = (Number(j / 4) + NUMBER(0.5) + NUMBER(0.5) * gaussNode(j % 4)) / Number(panels);
  Number turn = circle.turn * (NUMBER(2.0) * at - NUMBER(1.0));
  Number level = horizontalLength(axis);
  // y of `up` is 1 - axis.y^2 over `level`, which would lose its digits near the poles.
  Number3 up = level > NUMBER(1e-6) ? Number3(-axis.x * axis.y / level, level, -axis.z * axis.y / level)
                                    : Number3(NUMBER(1.0), NUMBER(0.0), NUMBER(0.0));
  return axis * circle.cosine + (up * cos(turn) + cross(axis, up) * sin(turn)) * circle.sine;
}

// Panels of the rule, out and around, for skies of luminance.glsl: its error is below 0.4 % of the radiance there
// (tests/sky/reflection_rule_test.cpp).
INLINE int lobePanelsOut(Number power) { return power > NUMBER(4000.0) ? 2 : 4; }
INLINE int lobePanelsAround(Number power) {
  return power > NUMBER(1000.0) ? 2 : power > NUMBER(100.0) ? 4 : power > NUMBER(10.0) ? 8 : 12;
}
