// Who has the keyboard: what is open over the page keeps every key that is pressed in it, also when what had the focus
// there is taken away (G04).

/** What keeps its keys: the commands of the page do not hear them. */
const KEEPERS = '[role=dialog], [role=alertdialog], [role=menu], [data-keeps-keys]'
const FIELDS =
  'input:not([type=checkbox]):not([type=radio]):not([type=button]):not([type=range]), textarea, select, [contenteditable=true]'

/** Those that had the keyboard one after the other; the last of them that is still open has it. */
let keepers: HTMLElement[] = []
/** Of each the field in which somebody wrote last. */
const written = new WeakMap<HTMLElement, HTMLElement>()

const isElement = (target: EventTarget | null): target is HTMLElement =>
  typeof Element !== 'undefined' && target instanceof Element

/** What keeps the keys that are pressed at a place of the page. */
export const keeperOf = (target: EventTarget | null): HTMLElement | undefined =>
  (isElement(target) && target.closest<HTMLElement>(KEEPERS)) || undefined

export const isTyping = (target: EventTarget | null): boolean => isElement(target) && target.closest(FIELDS) !== null

const isNowhere = (): boolean => document.activeElement === null || document.activeElement === document.body

function lastKeeper(): HTMLElement | undefined {
  keepers = keepers.filter((keeper) => keeper.isConnected)
  return keepers.at(-1)
}

/** What keeps keys pressed now: what has the focus, or what had it before it was taken away. */
export const keeperNow = (): HTMLElement | undefined => (isNowhere() ? lastKeeper() : keeperOf(document.activeElement))

/** Whether nothing has the keyboard, so that keys mean what is shown. */
export const isPages = (): boolean => isNowhere() && lastKeeper() === undefined

/** The focus came to something, or something was pressed. */
export function wentTo(target: EventTarget | null): void {
  const keeper = keeperOf(target)
  if (!keeper) {
    keepers = []
    return
  }
  keepers = [...keepers.filter((other) => other !== keeper), keeper]
  if (isTyping(target)) written.set(keeper, target as HTMLElement)
}

/** A key was pressed: where what had the focus was taken away, the dialog that it stood in has the keyboard again. */
export function comesBack(event: KeyboardEvent): void {
  const keeper = isNowhere() ? lastKeeper() : undefined
  if (!keeper) return
  const field = written.get(keeper)
  const isThere = field !== undefined && keeper.contains(field) && !(field as HTMLInputElement).disabled
  ;(isThere ? field : keeper).focus({ preventScroll: true })
  if (event.key === 'Enter') event.preventDefault() // meant what is no more
}
