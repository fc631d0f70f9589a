// The look without colour: nothing of it has a hue, and what a hue says elsewhere is said by lines. R-G09
import { readFileSync } from 'node:fs'
import { describe, expect, test } from 'vitest'
import { HUES, dash, hue } from '../../src/values/inks'

const css = readFileSync(new URL('../../src/theme.css', import.meta.url), 'utf8')

/** What the rule of exactly this selector says, by property. */
function declarations(selector: string): Record<string, string> {
  const start = css.indexOf(`\n${selector} {`)
  expect(start, selector).toBeGreaterThan(-1)
  const body = css.slice(css.indexOf('{', start) + 1, css.indexOf('}', start)).replace(/\/\*.*?\*\//gs, '')
  const pairs = body.split(';').filter((line) => line.includes(':'))
  return Object.fromEntries(pairs.map((line) => [line.slice(0, line.indexOf(':')).trim(), line.split(':')[1]!.trim()]))
}

const colourful = Object.entries(declarations(':root')).filter(([, value]) =>
  [...value.matchAll(/#([0-9a-f]{6})/g)].some(([, hex]) => new Set(hex!.match(/../g)).size > 1),
)
const mono = declarations(':root.monochrome')

describe('the monochrome look', () => {
  test('every colour of the page that has a hue is another one there', () => {
    const missing = colourful.map(([name]) => name).filter((name) => !(name in mono) && name !== '--shade')
    expect(missing).toEqual([])
  })

  test('no colour of it has a hue, and what comes from files loses its own', () => {
    for (const [name, value] of Object.entries(mono).filter(([name]) => name.startsWith('--')))
      expect(value, name).toMatch(/^#(..)\1\1$/)
    expect(mono['filter']).toBe('grayscale(1)')
  })

  test('every state of a task has a line of its own', () => {
    const lines = ['ON', 'ASKING', 'WAITING', 'ERROR'].map((state) => declarations(`.task.${state} .box`))
    const drawn = [declarations('.task .box'), ...lines]
    const styles = drawn.map((line) => `${line['stroke-width']} ${line['stroke-dasharray'] ?? 'solid'}`)
    expect(new Set(styles).size).toBe(styles.length)
  })

  test('who supplies a line is told by its dashes', () => {
    const dashes = ['live', 'idle', 'stale'].map((kind) => declarations(`.wire.${kind}`)['stroke-dasharray'])
    expect(new Set(dashes).size).toBe(3)
  })

  test('what is greyed has a broken outline', () => {
    expect(css).toMatch(/\.greyed \.frame,\s*\.greyed \.band,\s*\.troubled \.band {\s*stroke-dasharray: 4 3/)
  })

  test('twelve elements of a plot differ by grey and dash together', () => {
    const lines = [...Array(12).keys()].map((element) => `${mono[hue(element)]} ${dash(element).join(' ')}`)
    expect(new Set(lines).size).toBe(12)
    expect(HUES.every((name) => name in mono)).toBe(true)
  })
})
