// SPDX-License-Identifier: Apache-2.0
// Stand-ins for the types of Unity that the C# of docs/engines.md uses: names, signatures and results as its scripting
// reference documents them.
using System;

public struct Vector3 {
  public float x, y, z;
  public Vector3(float x, float y, float z) { this.x = x; this.y = y; this.z = z; }
  public static Vector3 operator -(Vector3 v) { return new Vector3(-v.x, -v.y, -v.z); }
}

public struct Color {
  public float r, g, b, a;
  public Color(float r, float g, float b, float a = 1f) { this.r = r; this.g = g; this.b = b; this.a = a; }
  public float maxColorComponent { get { return Math.Max(Math.Max(r, g), b); } }
  public Color gamma { get { return new Color(Encoded(r), Encoded(g), Encoded(b), a); } }
  public Color linear { get { return new Color(Decoded(r), Decoded(g), Decoded(b), a); } }
  public static Color operator /(Color c, float s) { return new Color(c.r / s, c.g / s, c.b / s, c.a / s); }
  static float Encoded(float v) { return v <= 0.0031308f ? 12.92f * v : 1.055f * (float)Math.Pow(v, 1 / 2.4) - 0.055f; }
  static float Decoded(float v) { return v <= 0.04045f ? v / 12.92f : (float)Math.Pow((v + 0.055f) / 1.055f, 2.4); }
}

public static class Mathf {
  public const float PI = 3.14159274f;
  public static float Max(float a, float b) { return Math.Max(a, b); }
}

public class Transform { public Vector3 forward { get; set; } }

public class Light {
  public Transform transform = new Transform();
  public float intensity { get; set; }
  public Color color { get; set; }
}

public enum AmbientMode { Skybox, Trilight, Flat, Custom }

public struct SphericalHarmonicsL2 {
  float[] numbers;
  public float this[int rgb, int coefficient] {
    get { return numbers[9 * rgb + coefficient]; }
    set { if (numbers == null) numbers = new float[27]; numbers[9 * rgb + coefficient] = value; }
  }
}

public static class RenderSettings {
  public static AmbientMode ambientMode { get; set; }
  public static SphericalHarmonicsL2 ambientProbe { get; set; }
}
