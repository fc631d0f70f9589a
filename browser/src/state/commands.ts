// What can be done by name, key or menu. The keymap, the palette, the menus and the help sheet all read this list.

import { isTyping, keeperNow, keeperOf } from './keyboard'
import { look, type Level } from './look.svelte'

export type Group =
  'file' | 'edit' | 'canvas' | 'library' | 'run' | 'view' | 'help' | 'application' | 'dictionary' | 'review'

export interface Command {
  id: string
  title: () => string
  /** Other words by which it may be looked for. */
  also?: () => string
  group: Group
  /** As in `Ctrl+Shift+Z`, `/`, `Delete`; the first is shown. Ctrl stands for the command key of a Mac, too. */
  keys?: readonly string[]
  /** The level at which it means something; else at both. */
  level?: Level
  when?: () => boolean
  run: () => unknown
  /** Whether its keys work while a text is being typed, and in dialogs. */
  whileTyping?: boolean
  /** Whether its keys work in dialogs, which keep all others. */
  inDialogs?: boolean
}

const commands = new Map<string, Command>()

/** Add a command; a later one of the same id takes its place. */
export function command(entry: Command): void {
  commands.set(entry.id, entry)
}

export const allCommands = (): Command[] => [...commands.values()]
export const isAvailable = (entry: Command): boolean =>
  (entry.level === undefined || entry.level === look.level) && (entry.when?.() ?? true)
export const findCommand = (id: string): Command | undefined => commands.get(id)

export function run(id: string): void {
  const entry = commands.get(id)
  if (entry && isAvailable(entry)) entry.run()
}

/** Run what the pressed keys stand for; true where they stood for something. Esc in a field that has no use for it leaves the field. */
export function press(event: KeyboardEvent): boolean {
  if (event.isComposing || event.defaultPrevented) return false
  const typing = isTyping(event.target)
  const isKept = (keeperOf(event.target) ?? keeperNow()) !== undefined
  for (const entry of commands.values()) {
    if ((typing && !entry.whileTyping) || (isKept && !entry.whileTyping && !entry.inDialogs)) continue
    if (!entry.keys?.some((keys) => matches(keys, event)) || !isAvailable(entry)) continue
    event.preventDefault()
    entry.run()
    return true
  }
  if (typing && event.key === 'Escape' && !clearsItself(event.target)) (event.target as HTMLElement).blur()
  return false
}

/** A field of a search that holds something: the browser empties it first. */
function clearsItself(target: EventTarget | null): boolean {
  const field = target as HTMLInputElement
  return field.type === 'search' && field.value !== ''
}

export type Pressed = Pick<KeyboardEvent, 'key' | 'ctrlKey' | 'metaKey' | 'shiftKey' | 'altKey'>

/** Whether an event is these keys. Where a sign itself needs Shift (as ? does on many keyboards), Shift is not asked. */
export function matches(keys: string, event: Pressed): boolean {
  const parts = keys.split('+')
  const key = keys.endsWith('++') || keys === '+' ? '+' : parts.at(-1)
  if (key === undefined || key.toLowerCase() !== event.key.toLowerCase()) return false
  if (parts.includes('Ctrl') !== (event.ctrlKey || event.metaKey)) return false
  if (parts.includes('Alt') !== event.altKey) return false
  const isSign = key.length === 1 && !/[a-z]/i.test(key)
  return isSign || parts.includes('Shift') === event.shiftKey
}
