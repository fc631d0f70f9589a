// How the page is built: into the Python package, with relative addresses, so that it may be served below any path.
import { svelte } from '@sveltejs/vite-plugin-svelte'
import { defineConfig } from 'vitest/config'

// While developing, the page comes from here and everything live from a program that runs beside it.
const program = process.env.ONIKA_ADDRESS ?? 'http://127.0.0.1:8420'

export default defineConfig({
  plugins: [svelte()],
  base: './',
  build: {
    outDir: '../src/onika/web/static',
    emptyOutDir: true,
    target: 'es2022',
    chunkSizeWarningLimit: 1024, // three.js, fetched only when a workcell is looked at
  },
  // the program lets in its own page only; the cookie comes from opening its printed address first
  server: {
    host: '127.0.0.1',
    proxy: { '/ws': { target: program, ws: true, changeOrigin: true, rewriteWsOrigin: true } },
  },
  test: {
    include: ['test/**/*.test.ts'],
    environment: 'node',
    pool: 'threads',
    passWithNoTests: true,
    testTimeout: 60_000, // a busy machine is no fault
  },
})
