// Instances of the package's classes from data that is checked already: results of the core, and of arguments that were checked.

/** Constructors take its data as it is. */
class Checked {
  data: unknown;

  constructor(data: unknown) {
    this.data = data;
  }
}

/**
 * An instance of a class of this package.
 *
 * @internal
 * @param data what the constructor reads with `checkedData`
 */
export function fromChecked<T>(Class: new (data: any, ...further: any[]) => T, data: unknown): T {
  return new Class(new Checked(data));
}

/**
 * The data for which `fromChecked` called a constructor.
 *
 * @internal
 * @param argument the first one of the constructor
 * @returns undefined for arguments that are not checked yet
 */
export function checkedData<T>(argument: unknown): T | undefined {
  return argument instanceof Checked ? (argument.data as T) : undefined;
}
