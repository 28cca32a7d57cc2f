import { messageOf } from "../editor/check.js";

/** What is wrong with the attributes of an element. */
export class Problems {
  #messages: Map<string, string> = new Map();
  #report;

  /** @param report is called once with each message */
  constructor(report: (message: string) => void) {
    this.#report = report;
  }

  get messages(): string[] {
    return [...this.#messages.values()];
  }

  /**
   * Reads an attribute.
   *
   * @param read may throw; then the message of the error is reported
   */
  attempt(name: string, read: () => void) {
    const before = this.#messages.get(name);
    this.#messages.delete(name);
    try {
      read();
    } catch (error) {
      const message = messageOf(error);
      this.#messages.set(name, message);
      if (message !== before) this.#report(message);
    }
  }

  /** The attribute has a valid value now. */
  forget(name: string) {
    this.#messages.delete(name);
  }
}
