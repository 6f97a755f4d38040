// SPDX-License-Identifier: Apache-2.0
// Runs the C# of docs/engines.md for Unity on the runtime itself, and compares the scene that it sets with the runtime's
// light. Exit status 1 when they differ.
using System;
using System.Runtime.InteropServices;

static partial class Game {
  [DllImport("welkin_plugin")] static extern int test_light_count();
  [DllImport("welkin_plugin")] static extern IntPtr test_sample(int light);
  [DllImport("welkin_plugin")] static extern int test_normal(int index, [Out] float[] normal);
  [DllImport("welkin_plugin")] static extern void test_sun(int light, [Out] float[] direction, [Out] float[] irradiance);
  [DllImport("welkin_plugin")] static extern void test_irradiance(int light, float[] normal, [Out] float[] irradiance);

  // Unity's ShadeSH9 with the constants that Unity makes of an ambient probe: irradiance over pi.
  static float Shaded(SphericalHarmonicsL2 p, int c, float[] n) {
    return p[c, 3] * n[0] + p[c, 1] * n[1] + p[c, 2] * n[2] + p[c, 0] - p[c, 6] + p[c, 4] * n[0] * n[1]
      + p[c, 5] * n[1] * n[2] + 3 * p[c, 6] * n[2] * n[2] + p[c, 7] * n[2] * n[0] + p[c, 8] * (n[0] * n[0] - n[1] * n[1]);
  }

  static int Main() {
    double most = 0, mostOfSun = 0;
    int compared = 0;
    for (int light = 0; light < test_light_count(); ++light) {
      var sun = new Light();
      float[] direction = new float[3], sunIrradiance = new float[3], normal = new float[3], turned = new float[3], e = new float[3];
      test_sun(light, direction, sunIrradiance);
      RenderSettings.ambientMode = AmbientMode.Skybox;
      LightScene(test_sample(light), sun, direction, sunIrradiance);
      if (RenderSettings.ambientMode != AmbientMode.Custom) return 1;
      double largest = 0, mean = 0;
      int count = 0;
      for (; test_normal(count, normal) != 0; ++count) {
        test_irradiance(light, normal, e);
        welkin_axes_vector(Axes, normal, turned);
        for (int c = 0; c < 3; ++c) {
          double shown = Math.Max(Shaded(RenderSettings.ambientProbe, c, turned), 0) * Math.PI;
          largest = Math.Max(largest, Math.Abs(shown - e[c]));
          mean += e[c];
        }
      }
      compared += count;
      most = Math.Max(most, largest / (mean / (3 * count)));
      welkin_axes_vector(Axes, direction, turned);
      var forward = sun.transform.forward;
      var colour = sun.color.linear;
      float[] f = { forward.x, forward.y, forward.z }, lit = { colour.r, colour.g, colour.b };
      for (int c = 0; c < 3; ++c)
        mostOfSun = Math.Max(mostOfSun, Math.Max(Math.Abs(f[c] + turned[c]),
          Math.Abs(lit[c] * sun.intensity * Math.PI / sunIrradiance[c] - 1)));
    }
    Console.WriteLine("Unity's C#, {0} normals: {1:e1}; its sun: {2:e1}", compared, most, mostOfSun);
    // Floats, as kRounding of engine_light.h; the sun's colour also goes through the two curves of sRGB.
    return compared > 600 && most < 3e-6 && mostOfSun < 1e-5 ? 0 : 1;
  }
}
