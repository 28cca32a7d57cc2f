// The code of a sample: its literals and printed lines follow the inputs of the figure.

/** A number in code. */
const NUMBER = /-?\d+(?:\.\d+)?(?:e[-+]?\d+)?/g;

export class LiveCode {
  /** @param {Element | null | undefined} code */
  constructor(code) {
    this.code = code;
  }

  /**
   * Writes an input as a literal; its line breaks stay.
   *
   * @param {string} name
   * @param {unknown} value numbers in nested arrays, a number, a text, true or false
   */
  setInput(name, value) {
    const parts = this.code?.querySelectorAll(`[data-input="${name}"]`) ?? [];
    if (typeof value === "string" || typeof value === "boolean") {
      for (const part of parts) part.textContent = JSON.stringify(value);
      return;
    }
    const numbers = [value].flat(2);
    for (const part of parts)
      part.textContent = (part.textContent ?? "").replace(NUMBER, () => String(numbers.shift()));
  }

  /** @param {string[]} lines */
  setOutput(lines) {
    const parts = [...(this.code?.querySelectorAll("[data-output]") ?? [])];
    for (const [k, part] of parts.entries()) {
      const rest = k === parts.length - 1 ? lines.slice(k).join(" · ") : lines[k];
      part.textContent = rest ?? "";
    }
  }
}
