// Beside Run stands what the program would come to: how long, what goes wrong, and whether the workcell is as assumed.
import { expect, test } from 'vitest'
import { forecastLines } from '../../src/progress/forecast'
import { plain } from '../../src/texts/say'

const texts = (...given: Parameters<typeof forecastLines>): string[] => forecastLines(...given).map(({ text }) => text)

test('without a forecast nothing is said, and while it is made only that', () => {
  expect(forecastLines(undefined, true)).toEqual([])
  expect(forecastLines({}, true)).toEqual([])
  expect(forecastLines({ state: 'none' }, true)).toEqual([])
  expect(texts({ state: 'going', mishaps: 2 }, false)).toEqual(['Looking ahead…'])
})

test('a whole one says how long it takes and how everything stands then', () => {
  const forecast = {
    state: 'whole',
    lasts_s: 41.2345,
    worlds: ['boxes'],
    standing: [plain('the lamp is lit'), plain('the hand is open')],
  }
  expect(texts(forecast as never, true)).toEqual([
    'It will take 41.2 s; then: the lamp is lit, the hand is open.',
    'Nothing touches what it should not.',
    'The workcell stands as this assumes.',
  ])
  expect(texts({ state: 'whole', lasts_s: 3 }, true)[0]).toBe('It will take 3 s.')
})

test('what goes wrong takes the place of what is clear', () => {
  const lines = forecastLines({ state: 'whole', lasts_s: 3, mishaps: 2, worlds: ['boxes'] }, true)
  expect(lines.map(({ look }) => look)).toEqual(['plain', 'mishaps', 'dim'])
  expect(lines[1]!.text).toBe('On the way 2 things go wrong; their icons are marked.')
})

test('one that is over early where something is marked says when, and not in the words of a task', () => {
  const cause = plain('x.appl:4: ctraj is in error')
  expect(texts({ state: 'part', lasts_s: 4.04, mishaps: 1, cause }, true).slice(0, 2)).toEqual([
    'It would stop after 4 s.',
    'On the way 1 thing goes wrong; its icon is marked.',
  ])
  const long = { ...cause, key: 'desk.forecast_long' }
  expect(texts({ state: 'part', mishaps: 1, cause: long } as never, true)[0]).toMatch(/^Not foreseen to its end/)
})

test('one that does not reach the end says why, and promises nothing of what comes behind', () => {
  expect(texts({ state: 'part', cause: plain('it asks for a value') }, true)).toEqual([
    'Not foreseen to its end: it asks for a value',
    'The workcell stands as this assumes.',
  ])
})

test('where the workcell stands otherwise, that is said', () =>
  expect(texts({ state: 'whole', lasts_s: 3, worlds: ['boxes'] }, false).at(-1)).toContain(
    'does not stand as this assumes',
  ))

test('of a workcell that does not say what is touched in it nothing is promised', () => {
  expect(texts({ state: 'whole', lasts_s: 3, worlds: ['bench'], unwatched: ['bench'] }, true)).toEqual([
    'It will take 3 s.',
    'What is touched in bench is not foreseen.',
    'The workcell stands as this assumes.',
  ])
  const both = texts({ state: 'whole', lasts_s: 3, worlds: ['boxes', 'bench'], unwatched: ['bench'] }, true)
  expect(both.slice(1, 3)).toEqual(['Nothing touches what it should not.', 'What is touched in bench is not foreseen.'])
})

test('of a program without a workcell only its time is foreseen', () =>
  expect(texts({ state: 'whole', lasts_s: 0.9 }, true)).toEqual(['It will take 0.9 s.']))
