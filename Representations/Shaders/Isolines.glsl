// Draws lines where (value - first) / spacing is an integer, with a constant width in pixels.
uniform float isolineFirst;
uniform float isolineSpacing;
uniform float isolineWidth;
uniform vec3 isolineColor;
VARYING float level;
float levelRate;

// Called before pixels are discarded: next to these, rates are undefined, and 0 on NVIDIA cards.
void findLevelRate() { levelRate = fwidth(level); }

void isolines(inout vec3 ambient, inout vec3 diffuse, inout float opacity)
{
  float steps = (level - isolineFirst) / isolineSpacing;
  float pixels = abs(steps - round(steps)) / max(levelRate / abs(isolineSpacing), 1.0e-30);
  float amount = clamp(0.5 * isolineWidth + 0.5 - pixels, 0.0, 1.0);
  ambient = mix(ambient, isolineColor, amount);
  diffuse = mix(diffuse, vec3(0.0), amount);
}
