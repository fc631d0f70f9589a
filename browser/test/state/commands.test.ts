// Keys find their command; while something is typed they are letters.
import { beforeEach, describe, expect, test, vi } from 'vitest'
import { command, findCommand, matches, press, run, type Pressed } from '../../src/state/commands'

const pressed = (key: string, more: Partial<Pressed> = {}): Pressed => ({
  key,
  ctrlKey: false,
  metaKey: false,
  shiftKey: false,
  altKey: false,
  ...more,
})

describe('keys', () => {
  test.each([
    ['Ctrl+Z', pressed('z', { ctrlKey: true }), true],
    ['Ctrl+Z', pressed('z', { metaKey: true }), true],
    ['Ctrl+Z', pressed('Z', { ctrlKey: true, shiftKey: true }), false],
    ['Ctrl+Shift+Z', pressed('Z', { ctrlKey: true, shiftKey: true }), true],
    ['C', pressed('c'), true],
    ['C', pressed('C', { shiftKey: true }), false],
    ['C', pressed('c', { ctrlKey: true }), false],
    ['?', pressed('?', { shiftKey: true }), true],
    ['/', pressed('/', { shiftKey: true }), true],
    ['Ctrl+.', pressed('.', { ctrlKey: true }), true],
    ['+', pressed('+', { shiftKey: true }), true],
    ['Ctrl++', pressed('+', { ctrlKey: true }), true],
    ['Pause', pressed('Pause'), true],
    ['Alt+N', pressed('n', { altKey: true }), true],
    ['Alt+N', pressed('n'), false],
  ])('%s', (keys, event, is) => expect(matches(keys, event)).toBe(is))
})

describe('a command', () => {
  const deed = vi.fn()
  let isPossible = true
  beforeEach(() => {
    vi.stubGlobal('document', { activeElement: null })
    deed.mockClear()
    isPossible = true
    command({ id: 'test.deed', group: 'help', title: () => 'Deed', keys: ['F9'], when: () => isPossible, run: deed })
  })
  const event = (): KeyboardEvent =>
    ({ ...pressed('F9'), target: null, preventDefault: vi.fn() }) as unknown as KeyboardEvent

  test('runs by its keys and by its name', () => {
    expect(press(event())).toBe(true)
    run('test.deed')
    expect(deed).toHaveBeenCalledTimes(2)
  })

  test('does not run where it is not possible', () => {
    isPossible = false
    expect(press(event())).toBe(false)
    run('test.deed')
    expect(deed).not.toHaveBeenCalled()
  })

  test('gives way to a later one of the same name', () => {
    const later = vi.fn()
    command({ id: 'test.deed', group: 'help', title: () => 'Later', run: later })
    run('test.deed')
    expect([later.mock.calls.length, deed.mock.calls.length, findCommand('test.deed')?.title()]).toEqual([
      1,
      0,
      'Later',
    ])
  })
})
