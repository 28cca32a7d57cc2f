// Announcements for screen readers, made once nothing has changed for a while.

/** The pause after the last change: a drag is announced once. */
const PAUSE_MS = 500;

/** A live region whose text changes after a pause. */
export class Announcer {
  #live;
  #news;
  #words = "";
  #timer = 0;

  /**
   * @param news asked for just before something is said: what else there is to say
   */
  constructor(live: HTMLElement, news: () => string) {
    this.#live = live;
    this.#news = news;
  }

  say(words: string = this.#words) {
    this.#words = words;
    clearTimeout(this.#timer);
    this.#timer = window.setTimeout(() => this.#speak(), PAUSE_MS);
  }

  end() {
    clearTimeout(this.#timer);
  }

  #speak() {
    const words = [this.#words, this.#news()].filter(Boolean).join(". ");
    if (words) this.#live.textContent = words;
    this.#words = "";
  }
}

/** Only where it differs: a text node that is replaced for nothing costs a layout. */
export function setText(element: HTMLElement, text: string) {
  if (element.textContent !== text) element.textContent = text;
}
