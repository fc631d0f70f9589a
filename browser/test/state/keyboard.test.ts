// R-G04: an open dialog keeps every key, also when the button that had the focus is taken away.
import { beforeEach, expect, test, vi } from 'vitest'
import { command, press } from '../../src/state/commands'
import { comesBack, isPages, keeperNow, wentTo } from '../../src/state/keyboard'

/** As much of an element as is asked. */
class Part {
  isConnected = true
  disabled = false
  constructor(
    readonly kind: 'dialog' | 'field' | 'button' | 'paper',
    readonly within?: Part,
  ) {}
  closest(selector: string): Part | null {
    if (selector.includes('dialog')) return this.kind === 'dialog' ? this : (this.within ?? null)
    return this.kind === 'field' ? this : null
  }
  contains(other: Part): boolean {
    return other.isConnected && other.within === this
  }
  focus(): void {
    page.activeElement = this
    wentTo(this as unknown as EventTarget)
  }
}

const body = new Part('paper')
const page: { activeElement: Part; body: Part } = { activeElement: body, body }
const removed = (part: Part): void => {
  part.isConnected = false
  if (page.activeElement === part) page.activeElement = body
}
const typed = (key: string, target: Part = page.activeElement): KeyboardEvent =>
  ({ key, target, ctrlKey: false, metaKey: false, altKey: false, shiftKey: false, preventDefault: vi.fn() }) as never

const cut = vi.fn()
const stop = vi.fn()
let dialog = new Part('dialog')

beforeEach(() => {
  vi.stubGlobal('Element', Part)
  vi.stubGlobal('document', page)
  page.activeElement = body
  wentTo(body as never)
  cut.mockClear()
  stop.mockClear()
  command({ id: 'test.cut', group: 'edit', title: () => '', keys: ['Delete', 'X'], run: cut })
  command({ id: 'test.stop', group: 'run', title: () => '', keys: ['Pause'], run: stop, whileTyping: true })
  dialog = new Part('dialog')
})

test('a key on a button of a dialog is none of the page, but everything is stopped from anywhere', () => {
  new Part('button', dialog).focus()
  expect(press(typed('Delete'))).toBe(false)
  expect(press(typed('Pause'))).toBe(true)
  expect([cut.mock.calls.length, stop.mock.calls.length]).toEqual([0, 1])
})

test('where the button that was pressed is taken away, what is typed on goes into the field', () => {
  const field = new Part('field', dialog)
  field.focus()
  const button = new Part('button', dialog)
  button.focus()
  removed(button)
  expect(isPages()).toBe(false)
  const key = typed('x', body)
  comesBack(key)
  expect(page.activeElement).toBe(field)
  expect(press(key)).toBe(false)
  expect(cut).not.toHaveBeenCalled()
})

test('Enter that was meant for a button that is no more does nothing', () => {
  const button = new Part('button', dialog)
  button.focus()
  removed(button)
  const key = typed('Enter', body)
  comesBack(key)
  expect(key.preventDefault).toHaveBeenCalledOnce()
  expect(page.activeElement).toBe(dialog)
})

test('a dialog over another gives the keyboard back to it', () => {
  const field = new Part('field', dialog)
  field.focus()
  const over = new Part('dialog')
  new Part('button', over).focus()
  removed(over)
  page.activeElement = body
  expect(keeperNow()).toBe(dialog)
})

test('keys mean the page again when the dialog is closed, or when somebody pressed beside it', () => {
  dialog.focus()
  page.activeElement = body
  wentTo(body as never)
  expect(isPages()).toBe(true)
  expect(press(typed('Delete'))).toBe(true)
  dialog.focus()
  removed(dialog)
  expect([isPages(), press(typed('x'))]).toEqual([true, true])
})
